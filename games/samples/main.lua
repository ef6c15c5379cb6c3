-- A list of all samples: choose one with the pointer, the arrow keys or a pad; F1 comes back to this list.
local samples = game.list()
local names, chosen = {}, 1

scene.add { name = "camera", position = vec3(0, 1.2, 7), camera = {} }
scene.add { name = "sky", sky = { top = "#1c2340", horizon = "#3d4a75", ground = "#141828" } }
local dust = scene.add { name = "dust", position = vec3(0, 1, 0), particles = { rate = 15, life = 8, speed = 0.3, spread_degrees = 180,
  area = vec3(12, 6, 2), size = 0.05, size_end = 0.02, color = color(1, 0.9, 0.7, 0.6), glow = 1 } }

for i, sample in ipairs(samples) do
  names[i] = sample.path:gsub("%.lua$", ""):gsub("_", " "):gsub("/", "   ")
end

function draw_ui()
  local picked
  ui.text("Samples", { at = "top", size = 48 })
  ui.panel({ at = "left", x = 40, y = 20, width = 420 }, function()
    chosen, picked = ui.list(names, chosen, { height = 520 })
    ui.focus()
  end)
  local sample = samples[chosen]
  ui.panel({ at = "right", x = -40, y = 20, width = 620 }, function()
    ui.text(sample.about, { width = 560, size = 26 })
    ui.text("games/samples/" .. sample.path, { size = 18, color = "lightsteelblue" })
    if ui.button("Play") then picked = true end
  end)
  ui.text("F1 comes back to this list, F3 shows what the physics knows", { at = "bottom", size = 20 })
  if picked then game.open(sample.path) end
end
