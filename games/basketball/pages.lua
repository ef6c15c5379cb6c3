-- The pages of the menu, see scripts/std/menu.lua. What is chosen goes to main.lua as a message.
local menu = require "menu"
local settings = require "settings"
local scores = require "scores"

ui.style { accent = "#ffc65a", panel = color("#1c1630"):with_alpha(0.86), text = "#fbf6ea", size = 30 }
local gold, pale = color "#ffc65a", color "#cfc6e0"
local keys = { aim_left = "Aim left", aim_right = "Aim right", harder = "Harder", softer = "Softer", throw = "Throw",
  replay = "See it again", pause = "Pause" }

local pages = {}

local function button(label)
  local pressed = ui.button(label)
  if pressed then sound.play("sounds/click.ogg") end
  return pressed
end

-- `mine` is the entry of the round that was just played, or nil.
local function list_scores(mine)
  if #scores.list == 0 then ui.text("Nobody yet. Be the first!", { size = 26, color = pale }) end
  for i, entry in ipairs(scores.list) do
    ui.text(("%d.  %s  %d"):format(i, entry.name, entry.points), { size = 28, color = entry == mine and gold or pale })
  end
end

function pages.title()
  if button("Play") then scene.send("begin", "timed") end
  if button("Free play") then scene.send("begin", "free") end
  if button("Settings") then menu.open("settings") end
  if button("Quit") then game.quit() end
end

function pages.pause()
  menu.heading("Pause")
  if button("Go on") then menu.back() end
  if button("Start again") then scene.send("begin", scene.get("match").behaviours.match.mode) end
  if button("Settings") then menu.open("settings") end
  if button("Title") then scene.send("begin", "off") end
end

function pages.settings()
  menu.heading("Settings")
  settings.set("music", ui.slider("Music", settings.music))
  settings.set("effects", ui.slider("Effects", settings.effects))
  settings.set("arc", ui.toggle("Show the flight ahead", settings.arc))
  settings.set("slingshot", ui.toggle("Pull like a slingshot", settings.slingshot))
  settings.set("replays", ui.toggle("Show great baskets again", settings.replays))
  if button("Keys") then menu.open("keys") end
  if button("Back") then menu.back() end
end

function pages.keys()
  menu.heading("Keys")
  menu.keys(keys)
  if button("Back") then menu.back() end
end

function pages.over()
  local match = scene.get("match").behaviours.match
  local mine = scores.latest
  menu.heading(mine and mine == scores.list[1] and "New record!" or "Time!")
  ui.text(match.score .. " points", { size = 46, color = gold })
  local facts = ("%d of %d throws scored, best streak %d"):format(match.baskets, match.throws, match.best_streak)
  ui.text(facts, { size = 24, color = pale })
  if mine then
    local name, is_done = ui.field("Your name", mine.name, { length = 12 })
    scores.rename(mine, name)
    if is_done then ui.focus("Play again") end
    list_scores(mine)
  end
  if button("Play again") then scene.send("begin", "timed") end
  if button("Title") then scene.send("begin", "off") end
end

local places = {
  title = { at = "left", x = 64, y = 70, width = 300 },
  settings = { at = "center", width = 600, align = "center" },
  keys = { at = "center", width = 640, align = "center" },
  over = { at = "center", width = 520, align = "center" },
}

-- What stands around the title's buttons.
local function draw_title()
  ui.text("BASKETBALL", { at = "top", y = 40, size = 104, color = gold })
  ui.text("sixty seconds at dusk", { at = "top", y = 152, size = 30 })
  ui.panel({ at = "right", x = -64, y = 70, width = 300 }, function()
    ui.text("Best rounds", { size = 34, color = gold })
    list_scores()
  end)
end

local function draw()
  if menu.page() == "title" then draw_title() end
  menu.draw(pages, places[menu.page()])
end

return { draw = draw }
