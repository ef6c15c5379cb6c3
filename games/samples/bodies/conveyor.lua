-- Watch: the belt stands still and its surface runs: boxes on it are carried, and the second belt turns them away.
-- Change a `surface_velocity` and save.
scene.add { name = "camera", position = vec3(0, 5, 8), rotation_degrees = vec3(-32, 0, 0), camera = {} }
scene.add { name = "belt", position = vec3(-1.5, 0, 0), color = "dimgray", mesh = { shape = "box", size = vec3(7, 0.3, 1.4) },
  body = { type = "static", friction = 1, surface_velocity = vec3(1.5, 0, 0) } }       -- along its own x, m/s
scene.add { name = "side belt", position = vec3(2.9, -0.05, 1.5), color = "slategray",
  mesh = { shape = "box", size = vec3(1.8, 0.2, 5) }, body = { type = "static", friction = 1, surface_velocity = vec3(0, 0, 1.5) } }

local function parcel()
  local box = scene.add { position = vec3(-4.5, 0.6, random.between(-0.3, 0.3)), color = color.hsv(random.between(0, 1), 0.5, 0.9),
    mesh = { shape = "box", size = vec3(0.5, 0.5, 0.5) }, body = { mass = 2 } }
  task.after(12, box.destroy, box)
end

function start()
  parcel()
  task.every(1, parcel)
end
