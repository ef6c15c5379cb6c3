-- Watch: arrow keys walk, space jumps. The character is a kinematic capsule with a behaviour of the standard scripts:
-- it climbs steps, rides the platform, and pushes the crate.
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkseagreen",
  mesh = { shape = "box", size = vec3(24, 0.2, 24) }, body = "static" }
for i = 1, 5 do
  scene.add { name = "step " .. i, position = vec3(-5, i * 0.15, -i * 0.6), color = "burlywood",
    mesh = { shape = "box", size = vec3(3, 0.3 * i, 0.6) }, body = "static" }
end
scene.add { name = "crate", position = vec3(3, 0.4, 1), color = "peru", mesh = { shape = "box", size = vec3(0.8, 0.8, 0.8) },
  body = { mass = 20 } }
scene.add { name = "lift", position = vec3(4, 0.1, -4), color = "skyblue", mesh = { shape = "box", size = vec3(3, 0.2, 3) },
  body = "kinematic", behaviours = { platform = { travel = vec3(0, 3, 0), seconds = 3 } } }
local hero = scene.add { name = "hero", position = vec3(0, 0.9, 3), color = "tomato",
  mesh = { shape = "capsule", radius = 0.35, height = 1.7 }, body = "kinematic", behaviours = { character = {} } }
scene.add { name = "camera", position = vec3(0, 3, 9), camera = {}, behaviours = { follow_camera = { target = hero } } }

function update(dt)
  local view = scene.camera
  local ahead = view.forward:with_y(0):normalized()
  local wish = view.right * input.axis("left", "right") + ahead * input.axis("down", "up")
  hero.behaviours.character:move(wish:clamped(1) * 4)
end

function on_press(name)
  if name == "space" then hero.behaviours.character:jump() end
end
function on_release(name)
  if name == "space" then hero.behaviours.character:cut_jump() end
end
