-- What was reached since "Play": one table that main.lua fills and the screens read.
local levels = require "levels"

local run = { level = 1, coins = 0, all_coins = 0, falls = 0, seconds = 0, bonus = 0, before = 0, is_record = false }

-- Points of the levels before, and of this one.
function run.score()
  return math.max(0, run.before + run.coins * 100 + run.bonus - run.falls * 20)
end

function run.begin(level)
  run.before = level > 1 and run.score() or 0
  run.level, run.coins, run.falls, run.seconds, run.bonus = level, 0, 0, 0, 0
end

function run.finish()
  run.bonus = math.floor(math.max(0, levels[run.level].par - run.seconds)) * 5
end

function run.has_next() return run.level < #levels end

return run
