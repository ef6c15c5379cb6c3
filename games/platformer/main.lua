-- Little Heights: which screen is shown, which level is played, what was reached. What things do is in the behaviours;
-- what is where, in levels/*.json.
local hud = require "hud"

local levels = { "levels/one", "levels/two" }
local PAR = 150                         -- s; each second that a level takes less is worth 5 points

local state = "title"                   -- "title", "playing", "paused", "won" a level, "done"
local run = { level = 1, coins = 0, all_coins = 0, falls = 0, seconds = 0, bonus = 0 }

local function set_state(new_state)
  state = new_state
  time.paused = state == "paused"
  scene.get("player").behaviours.player.enabled = state == "playing"
end

local function begin(level)
  if level == 1 then run.coins, run.falls, run.bonus = 0, 0, 0 end
  run.level, run.seconds = level, 0
  scene.load(levels[level])
  state = "playing"
end

local function score() return math.max(0, run.coins * 100 + run.bonus - run.falls * 20) end

function on_scene_start()
  run.all_coins = run.coins
  for _, coin in ipairs(scene.tagged("coin")) do run.all_coins = run.all_coins + coin.behaviours.pickup.value end
  set_state(state)
end

function update(dt)
  if state == "playing" then run.seconds = run.seconds + dt end
end

function late_update()
  local report = game.report
  report.screen, report.level, report.score = state, run.level, score()
  report.coins, report.falls, report.seconds = run.coins, run.falls, run.seconds
end

-- ---- sent by behaviours

function on_pickup(value) run.coins = run.coins + value end

function on_checkpoint_reached() hud.tell("Checkpoint") end

function on_fell()
  run.falls = run.falls + 1
  hud.tell("Back to the checkpoint")
end

function on_goal_reached()
  if state ~= "playing" then return end
  run.bonus = run.bonus + math.floor(math.max(0, PAR - run.seconds)) * 5
  set_state(run.level < #levels and "won" or "done")
  if state == "done" then game.finish() end
end

-- ---- keys

function on_press(name)
  if name == "pause" and state == "playing" then
    set_state("paused")
  elseif name == "pause" and state == "paused" then
    set_state("playing")
  elseif name == "again" and state ~= "title" then
    game.restart()
  end
end

-- On release, so that the key that starts the game is not a jump as well.
function on_release(name)
  if name ~= "start" then return end
  if state == "title" then set_state("playing") elseif state == "won" then begin(run.level + 1) end
end

function draw_ui()
  if state ~= "title" then hud.draw(run) end
end
