-- Little Heights: which screen is shown, which level is played, what was reached. What things do is in the behaviours;
-- what is where, in levels/*.json; what the menus say, in pages.lua.
local hud, levels, menu, pages = require "hud", require "levels", require "menu", require "pages"
local records, run, settings = require "records", require "run", require "settings"

local beside = { at = "right", x = -60, width = 420, align = "center" }
local places = {                        -- of pages that do not stand in the middle
  title = { at = "left", x = 60, y = 70, width = 400 },
  keys = { at = "center", width = 640, align = "center" },
  won = beside, done = beside,
}

local state = "title"                   -- "title", "playing", "paused", "won" a level, "done" with all

local function set_state(new_state)
  state = new_state
  game.report.screen = state
  time.paused = state == "paused"
  input.pointer.captured = state == "playing"
  scene.get("player").behaviours.player.enabled = state == "playing"
end

function start()
  settings.apply()
  ui.style { accent = "#ffb83d", panel = color "#22304ae6", text = "#fff6e0" }
end

function on_scene_start()
  run.all_coins = 0
  for _, coin in ipairs(scene.tagged("coin")) do run.all_coins = run.all_coins + coin.behaviours.pickup.value end
  sound.music(levels[run.level].music)
  set_state(state)
  if state == "title" then
    scene.camera:send("title")
    menu.show("title")
  end
end

function update(dt)
  if state == "playing" then run.seconds = run.seconds + dt end
end

function late_update()
  local report = game.report
  report.level, report.score = run.level, run.score()
  report.coins, report.falls, report.seconds = run.coins, run.falls, run.seconds
end

function draw_ui()
  if state ~= "title" then hud.draw(run) elseif menu.page() == "title" then pages.draw_title() end
  menu.draw(pages, places[menu.page()])
  if state == "paused" and not menu.page() then set_state("playing") end
end

function on_press(name)
  if name ~= "pause" or state ~= "playing" then return end
  set_state("paused")
  menu.open("pause")
end

-- ---- sent by pages

function on_begin(level)
  local is_loaded = state == "title" and level == run.level      -- the title shows it already
  run.begin(level)
  menu.close()
  if is_loaded then
    set_state("playing")
    scene.camera:send("play")
  else
    state = "playing"
    time.paused = false
    scene.load(levels[level].scene)
  end
end

function on_to_title()
  run.begin(1)
  state = "title"
  time.paused = false
  scene.load(levels[1].scene)
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
  run.finish()
  run.is_record = records.add(run.level, run.seconds, run.coins)
  sound.play("sounds/goal.ogg")
  scene.get("player"):send("hooray")
  set_state(run.has_next() and "won" or "done")
  menu.show(state)
  if state == "done" then game.finish() end
end
