-- What stands on the screen in a round: points, clock, streak, and news of the last throw.
local dark, pale, gold, red = color("#171227"):with_alpha(0.72), color "#cfc6e0", color "#ffc65a", color "#ff6b57"

local hud = {}

local function shadowed(text, options)
  local shadow = { at = options.at, x = (options.x or 0) + 3, y = (options.y or 0) + 3, size = options.size, color = dark }
  ui.text(text, shadow)
  ui.text(text, options)
end

local function draw_score(match)
  ui.box { x = 24, y = 20, width = 170, height = 92, radius = 14, color = dark }
  ui.text("SCORE", { x = 42, y = 28, size = 20, color = pale })
  ui.text(match.score, { x = 42, y = 46, size = 56 })
end

local function draw_clock(match)
  local x = ui.width / 2
  if match.mode == "free" then
    ui.box { x = x - 110, y = 20, width = 220, height = 50, radius = 14, color = dark }
    return ui.text("Free play", { at = "top", y = 4, size = 30, color = gold })
  end
  local lit = match.seconds_left < 10 and red or gold
  ui.box { x = x - 210, y = 20, width = 420, height = 62, radius = 14, color = dark }
  ui.text(math.ceil(match.seconds_left), { x = x - 196, y = 25, size = 46, color = lit })
  ui.bar(match.seconds_left / match.round_seconds, { x = x - 124, y = 40, width = 316, height = 22, color = lit })
end

local function draw_streak(match)
  local x = ui.width - 24
  ui.box { x = x - 170, y = 20, width = 170, height = 92, radius = 14, color = dark }
  ui.text("STREAK " .. match.streak, { x = x - 152, y = 28, size = 20, color = pale })
  ui.text("×" .. match:times(), { x = x - 154, y = 46, size = 54, color = match:times() > 1 and gold or pale })
  for i = 1, match.most_times do      -- as many flames as points count times
    ui.box { x = x - 72 + (i - 1) * 19, y = 66, width = 13, height = 28, radius = 6.5,
      color = i <= match:times() and gold or pale:with_alpha(0.2) }
  end
end

local function draw_news(match)
  local age = time.now - match.news_at
  if age > match.news_seconds then return end
  local size = 64 + 40 * math.max(0, 1 - age / 0.15)      -- it drops in
  shadowed(match.news, { at = "top", y = 120 - 40 * age, size = size, color = gold })
end

function hud.draw(match)
  draw_score(match)
  draw_clock(match)
  draw_streak(match)
  draw_news(match)
  ui.text(("%d points from here"):format(match:spot().points), { at = "bottom_left", size = 26, color = pale })
  if match.throws == 0 then
    if match.aim.by == "nothing" and match.ball.state == "held" then
      shadowed("Pull back anywhere and let go, or aim with the arrows and press space", { at = "bottom", y = -44, size = 28 })
    end
  elseif match.replay:can_play() then
    ui.text(input.describe(input.bindings("replay")[1]) .. ": see it again", { at = "bottom_right", size = 26, color = pale })
  end
end

function hud.draw_replay()
  for _, y in ipairs { 0, ui.height - 72 } do ui.box { x = 0, y = y, width = ui.width, height = 72, color = "black" } end
  if time.now % 1 < 0.7 then ui.box { x = 32, y = 27, width = 18, height = 18, radius = 9, color = red } end
  ui.text("REPLAY", { x = 62, y = 16, size = 36 })
  ui.text("any key: back to the game", { at = "bottom_right", size = 26, color = pale })
end

return hud
