-- Basketball: as many points as you can in 60 seconds. Pull back from anywhere, let go to throw.
require "court"

local round_seconds = 60
local most_times = 3                  -- a streak makes points count up to so many times

local state = "title"                 -- "title", "playing", "over"
local score, throws, streak, best_streak = 0, 0, 0, 0
local seconds_left, over_at = 0, 0
local news, news_until = "", 0

local function ball() return scene.get("ball").behaviours.ball end
local function times() return math.min(streak + 1, most_times) end

local function report()
  game.report.score, game.report.throws, game.report.streak = score, throws, best_streak
end

local function play()
  state, seconds_left = "playing", round_seconds
  score, throws, streak, best_streak = 0, 0, 0, 0
  news = ""
  report()
  scene.restart()                     -- at the end of this tick: plates hang again, the ball is back
end

local function finish()
  state, over_at = "over", time.now
  game.finish()
end

function start() report() end

function on_press(name)
  -- Whoever pulls while the time runs out lets go and presses again at once: not before a second has passed.
  local waits = state == "title" or (state == "over" and time.now > over_at + 1)
  if waits and (name == "start" or name == "pointer") then play() end
end

function update(dt)
  if state == "playing" then
    seconds_left = math.max(seconds_left - dt, 0)
    if seconds_left == 0 and ball().state ~= "flying" then finish() end   -- a ball in the air still counts
  end
  ball().enabled = state == "playing"
end

function on_points(points, words)
  if state ~= "playing" then return end
  score = score + points * times()
  news, news_until = words .. " +" .. points * times(), time.now + 1.2
  report()
end

function on_throw_over(scored)
  throws = throws + 1
  streak = scored and streak + 1 or 0
  best_streak = math.max(best_streak, streak)
  report()
end

local function draw_round()
  ui.text("Score " .. score, { at = "top_left", size = 44 })
  ui.bar(seconds_left / round_seconds, { at = "top", width = 420, height = 22, color = seconds_left < 10 and "tomato" or "orange" })
  if times() > 1 then ui.text("next x" .. times(), { at = "top_right", size = 44, color = "gold" }) end
  if time.now < news_until then ui.text(news, { at = "center", size = 72, color = "gold" }) end
end

function draw_ui()
  if state == "playing" then return draw_round() end
  ui.box { at = "center", width = ui.width, height = 140 }
  ui.box { x = ui.width / 2 - 380, y = 650, width = 760, height = 54 }
  if state == "title" then
    ui.text("Basketball", { at = "center", size = 84, color = "gold" })
  else
    ui.text("Time! " .. score .. " points", { at = "center", size = 72, color = "gold" })
    ui.text(("%d throws, best streak %d"):format(throws, best_streak), { at = "top", size = 36 })
  end
  ui.text("Press space or click, then pull back and let go", { at = "bottom", size = 32 })
end
