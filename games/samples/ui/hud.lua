-- Watch: what is said in draw_ui() stays at its edge however the window is drawn out. Space adds a coin.
local coins, hurry = 3, 1

scene.add { name = "camera", position = vec3(0, 2, 6), rotation_degrees = vec3(-15, 0, 0), camera = {} }
scene.add { name = "floor", mesh = { shape = "box", size = vec3(12, 0.2, 12) }, color = "olivedrab", body = "static" }

function update(dt) hurry = math.max(0, hurry - dt / 30) end

function on_press(name)
  if name == "space" then coins = coins + 1 end
end

function draw_ui()
  ui.text("Coins " .. coins, { at = "top_left", size = 40, color = "gold" })
  ui.bar(hurry, { at = "top", y = 14, width = 400, color = hurry < 0.3 and "tomato" or "gold" })
  ui.panel({ at = "bottom_right", width = 240, padding = 16 }, function()
    ui.row(function()
      ui.text("Best")
      ui.text("17", { align = "right" })
    end)
    ui.row(function()
      ui.text("Falls")
      ui.text("2", { align = "right" })
    end)
  end)
  -- A button on its own hears the pointer only, so that space stays with the game.
  if ui.button("Again", { at = "top_right" }) then game.restart() end
end
