-- Basketball: as many points as you can in 60 seconds. Pull back from anywhere, let go to throw.
require "court"
require "yard"

local state = "title"                 -- "title", "playing", "over"
local over_at = 0

local function match() return scene.get("match").behaviours.match end

local function report()
  local m = match()
  game.report.score, game.report.throws, game.report.streak = m.score, m.throws, m.best_streak
end

function on_scene_start() if state == "playing" then match():begin("timed") end end

local function play()
  state = "playing"
  scene.restart()                     -- at the end of this tick: plates hang again, the ball is back
end

function on_time_up()
  state, over_at = "over", time.now
  game.finish()
end

function on_press(name)
  -- Whoever pulls while the time runs out lets go and presses again at once: not before a second has passed.
  local waits = state == "title" or (state == "over" and time.now > over_at + 1)
  if waits and (name == "throw" or name == "pointer") then play() end
  local replay = scene.get("replay").behaviours.replay
  if state == "playing" and name == "replay" then replay:play() elseif replay.is_playing then replay:stop() end
end

function update(dt) report() end

local function draw_round()
  local m = match()
  ui.text("Score " .. m.score, { at = "top_left", size = 44 })
  ui.bar(m.seconds_left / m.round_seconds, { at = "top", width = 420, height = 22, color = m.seconds_left < 10 and "tomato" or "orange" })
  if m:times() > 1 then ui.text("next x" .. m:times(), { at = "top_right", size = 44, color = "gold" }) end
  if time.now < m.news_until then ui.text(m.news, { at = "center", size = 72, color = "gold" }) end
end

function draw_ui()
  if state == "playing" then return draw_round() end
  ui.text(state == "title" and "Basketball" or "Time! " .. match().score .. " points", { at = "top", size = 72, color = "gold" })
  ui.text("Press space or click, then pull back and let go", { at = "bottom", size = 32 })
end
