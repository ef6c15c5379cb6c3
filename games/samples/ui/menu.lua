-- Watch: arrows, a pad's d-pad and the pointer all walk through the menu; what a widget is given comes back as its
-- value, so that a local is all that a setting needs.
local volume, lives, rain = 0.8, 3, false
local levels, level = { "Meadow", "Windmill", "Old bridge", "Cloud stairs", "Harbour", "Summit" }, 1
local name = "Ada"
local playing = false

ui.style { accent = "#7fd1ae" }

local function settings()
  ui.text("Before we go", { size = 48, align = "center" })
  volume = ui.slider("Volume", volume)
  lives = ui.slider("Lives", lives, { min = 1, max = 9, step = 1 })
  rain = ui.toggle("Rain", rain)
  name = ui.field("Name", name)
  level = ui.list(levels, level, { height = 200 })
  ui.row(function()
    if ui.button("Play") then playing = true end
    if ui.button("Quit") then game.quit() end
  end)
end

function draw_ui()
  if not playing then return ui.panel({ at = "center", width = 520 }, settings) end
  ui.text(("%s plays %s with %d lives%s"):format(name, levels[level], lives, rain and ", in the rain" or ""), { at = "center", width = 600, align = "center" })
  if ui.button("Back", { at = "bottom" }) then playing = false end
end
