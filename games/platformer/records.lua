-- The best time and the most coins of each level, kept from run to run.
local records = {}

local best = storage.load("best", {})

-- Nil for a level that was never finished.
function records.of(level) return best[level] end

-- Takes over what is better than before; returns whether the time was.
function records.add(level, seconds, coins)
  local before = best[level] or { seconds = math.huge, coins = 0 }
  best[level] = { seconds = math.min(before.seconds, seconds), coins = math.max(before.coins, coins) }
  storage.save("best", best)
  return seconds < before.seconds
end

return records
