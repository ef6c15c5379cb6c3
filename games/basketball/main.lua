-- Basketball: as many points as you can in 60 seconds. Rounds begin and end here; the rules are in match.lua.
require "court"
require "yard"
local hud = require "hud"
local menu = require "menu"
local pages = require "pages"
local scores = require "scores"
local settings = require "settings"

local mode = "off"                    -- of the match: "off", "timed", "free"

local function match() return scene.get("match").behaviours.match end
local function replay() return scene.get("replay").behaviours.replay end

function start()
  settings.apply()
  menu.show("title")
end

function on_begin(new_mode)
  mode = new_mode
  if mode == "off" then menu.show("title") else menu.close() end
  scene.restart()                     -- at the end of this tick: plates hang again, the ball is back
end

function on_scene_start()
  match():begin(mode)
  sound.music(mode == "off" and "sounds/music.ogg" or nil)
end

local function show_end()
  menu.show("over")
  game.finish()
end

function on_time_up()
  scores.add(match().score)
  task.after(1.2, show_end)           -- not at once: who still throws must not press a button
end

function on_press(name)
  if menu.page() then return end
  if replay().is_playing then
    replay():stop()
  elseif name == "replay" then
    replay():play()
  elseif name == "pause" then
    menu.open("pause")
  end
end

function update(dt)
  local m = match()
  game.report.score, game.report.throws, game.report.streak = m.score, m.throws, m.best_streak
end

function draw_ui()
  if replay().is_playing then hud.draw_replay() elseif not menu.page() then hud.draw(match()) end
  pages.draw()
  time.paused = menu.page() ~= nil and match():is_on()
end
