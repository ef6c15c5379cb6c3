-- The pages of the menu (scripts/std/menu.lua). What is more than leafing is sent to main.lua: "begin" (level), "to_title".
local hud, levels, menu, records, run = require "hud", require "levels", require "menu", require "records", require "run"
local settings = require "settings"

local pages = {}

local soft = color "#ffffffb0"

local function button(label, options)
  local is_pressed = ui.button(label, options)
  if is_pressed then sound.play("sounds/click.ogg") end
  return is_pressed
end

-- ---- title

function pages.title()
  if button("Play") then scene.send("begin", 1) end
  for number = 2, #levels do
    local label = ("Level %d: %s"):format(number, levels[number].name)
    if button(label, { enabled = records.of(number - 1) ~= nil }) then scene.send("begin", number) end
  end
  if button("Settings") then menu.open("settings") end
  if button("Quit") then game.quit() end
end

-- Beside the title's panel: the name of the game, and what was reached before.
function pages.draw_title()
  ui.image("pictures/title.png", { x = 50, y = 40, width = 460 })
  for number, level in ipairs(levels) do
    local best = records.of(number)
    if best then
      local line = ("%s   best %s, %d coins"):format(level.name, hud.clock(best.seconds), best.coins)
      ui.text(line, { at = "bottom_right", x = -40, y = -40 - 36 * (#levels - number), size = 24 })
    end
  end
end

-- ---- while one plays

function pages.pause()
  menu.heading("Paused")
  if button("Go on") then menu.back() end
  if button("Start the level again") then scene.send("begin", run.level) end
  if button("Settings") then menu.open("settings") end
  if button("To the title") then scene.send("to_title") end
end

local function result()
  ui.text(("Coins   %d of %d"):format(run.coins, run.all_coins))
  ui.text(("Time   %s%s"):format(hud.clock(run.seconds), run.is_record and "   new record!" or ""))
  ui.text(("Falls   %d"):format(run.falls))
  ui.text(("Score   %d"):format(run.score()), { color = "#ffd24a" })
  ui.space(8)
end

function pages.won()
  menu.heading(levels[run.level].name)
  result()
  if button("Next level") then scene.send("begin", run.level + 1) end
  if button("Again") then scene.send("begin", run.level) end
end

function pages.done()
  menu.heading("You made it!")
  result()
  if button("Play again") then scene.send("begin", 1) end
  if button("To the title") then scene.send("to_title") end
end

-- ---- settings

function pages.settings()
  local values = settings.values
  menu.heading("Settings")
  values.music = ui.slider("Music", values.music)
  values.effects = ui.slider("Sounds", values.effects)
  values.camera_speed = ui.slider("Camera speed", values.camera_speed, { min = 0.2, max = 3 })
  values.upside_down = ui.toggle("Camera upside down", values.upside_down)
  settings.apply()
  if button("Keys") then menu.open("keys") end
  if button("Back") then menu.back() end
end

function pages.keys()
  menu.heading("Keys")
  ui.text("Choose one, then press the new key.", { size = 22, color = soft })
  menu.keys { forward = "Forwards", back = "Backwards", left = "Left", right = "Right", jump = "Jump", use = "Use" }
  if button("As they were") then input.reset_bindings() end
  if button("Back") then menu.back() end
end

return pages
