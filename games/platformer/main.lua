-- Little Heights: title, playing, paused, done. What things do is in the behaviours; what is where, in levels/one.json.
local state = "title"
local coins, falls, seconds = 0, 0, 0
local all_coins = 0
local news, news_until = "", 0            -- a line that is shown for a while

local function set_state(new_state)
  state = new_state
  time.paused = state == "paused"
  scene.get("player").behaviours.player.enabled = state == "playing"
end

local function score()
  return coins * 100 + math.floor(math.max(0, 180 - seconds)) * 5 - falls * 20
end

local function tell(text) news, news_until = text, time.now + 2 end

function on_scene_start()
  all_coins = #scene.tagged("coin")
  set_state("title")
end

function update(dt)
  if state == "playing" then seconds = seconds + dt end
end

function late_update()
  local report = game.report
  report.coins, report.falls, report.seconds, report.score = coins, falls, seconds, score()
end

-- ---- sent by behaviours

function on_pickup(value) coins = coins + value end

function on_checkpoint_reached() tell("Checkpoint") end

function on_fell()
  falls = falls + 1
  tell("Back to the checkpoint")
end

function on_goal_reached()
  if state ~= "playing" then return end
  set_state("done")
  game.finish()
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
  if name == "start" and state == "title" then set_state("playing") end
end

-- ---- what is on the screen

local ink, paper, gold = "#ffffff", color "#1d2b3acc", "#ffd24a"

-- A card at the left of the screen: a headline and lines below it.
local function card(headline, lines)
  local width, height = 480, 150 + 38 * #lines
  local x, y = 16, (ui.height - height) / 2
  ui.box { x = x, y = y, width = width, height = height, color = paper }
  ui.box { x = x, y = y, width = width, height = 6, color = gold }
  ui.text(headline, { x = x + 40, y = y + 34, size = 60, color = ink })
  for i, line in ipairs(lines) do
    ui.text(line, { x = x + 42, y = y + 80 + 38 * i, size = 26, color = ink })
  end
end

local function clock() return ("%d:%04.1f"):format(seconds // 60, seconds % 60) end

local function playing_screen()
  ui.box { x = 16, y = 16, width = 268, height = 76, color = paper }
  ui.text(("Coins %d / %d"):format(coins, all_coins), { x = 32, y = 24, size = 30, color = ink })
  ui.bar(coins / math.max(1, all_coins), { x = 32, y = 66, width = 236, height = 12, color = gold })
  ui.box { x = ui.width - 136, y = 16, width = 120, height = 46, color = paper }
  ui.text(clock(), { at = "top_right", size = 30, color = ink })
  if time.now < news_until then
    ui.box { x = (ui.width - 440) / 2, y = 16, width = 440, height = 54, color = paper }
    ui.text(news, { at = "top", size = 34, color = gold })
  end
end

local screens = {
  title = function()
    card("Little Heights", { "Walk   W A S D  or arrows", "Jump   Space,  longer is higher", "Pause  Escape", "", "Press Space to start" })
  end,
  playing = playing_screen,
  paused = function()
    playing_screen()
    card("Paused", { "Escape  go on", "R  start again" })
  end,
  done = function()
    card("You made it!", { ("%d of %d coins"):format(coins, all_coins), ("%s  with %d falls"):format(clock(), falls),
      ("Score %d"):format(score()), "", "R  play again" })
  end,
}

function draw_ui() screens[state]() end
