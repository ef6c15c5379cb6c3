-- Watch: a street of lamps from one file, prefabs/lamp.json. What is written beside `prefab` overrides the file: the red
-- lamp is the same with another bulb. Change the file and save, and all change.
scene.add { name = "camera", position = vec3(-3, 3, 9), rotation_degrees = vec3(-12, -14, 0), camera = {} }
scene.add { name = "street", position = vec3(0, -0.05, 0), color = "dimgray", mesh = { shape = "box", size = vec3(16, 0.1, 8) } }
scene.add { name = "moon", rotation_degrees = vec3(-50, 30, 0), light = { type = "sun", color = "#8090c0", brightness = 0.15 } }
scene.add { name = "night", sky = { top = "#0a0e22", horizon = "#1c2340", ground = "#101010", brightness = 0.4 } }

for i = 1, 4 do
  scene.add { name = "lamp " .. i, prefab = "prefabs/lamp", position = vec3(i * 3 - 7.5, 0, -1) }
end
scene.add { name = "red lamp", prefab = "prefabs/lamp", position = vec3(0, 0, 2), scale = vec3(0.7, 0.7, 0.7),
  children = { { name = "bulb", material = { color = "red", glow = 2 }, light = { color = "red" } } } }

function update(dt)
  local broken = scene.get("lamp 3/bulb")                                   -- paths lead into what a prefab brought
  broken.visible = random.chance(0.9)
end
