-- Watch: a cylinder lies and stands: on its side it rolls, and only straight ahead; on its flat end it stays. So barrels
-- run down the planks and the cans stand, until they are hit. Space sends another barrel.
scene.add { name = "camera", position = vec3(0.4, 2.4, 6.5), rotation_degrees = vec3(-10, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "olivedrab",
  mesh = { shape = "box", size = vec3(16, 0.2, 8) }, body = "static" }

local function plank(x, y, degrees)
  scene.add { name = "plank", position = vec3(x, y, 0), rotation_degrees = vec3(0, 0, degrees), color = "peru",
    mesh = { shape = "box", size = vec3(4.6, 0.12, 1.8) }, body = { type = "static", friction = 1 } }
end
plank(0.4, 2.6, 11)
plank(-1.6, 1.1, -11)
scene.add { name = "stop", position = vec3(-4, 2, 0), color = "saddlebrown",
  mesh = { shape = "box", size = vec3(0.12, 1.6, 1.8) }, body = "static" }

-- Its axis is y, so that it stands as it is made.
for row = 0, 2 do
  for i = 1, 3 - row do
    scene.add { name = "can", position = vec3(3.5, row * 0.5 + 0.25, (i - 2 + row / 2) * 0.42), color = "silver",
      mesh = { shape = "cylinder", radius = 0.2, height = 0.5 }, body = { mass = 0.5 } }
  end
end

local function send_barrel()
  local barrel = scene.add { position = vec3(2.2, 3.5, 0), rotation_degrees = vec3(90, 0, 0), color = "firebrick",
    mesh = { shape = "cylinder", radius = 0.35, height = 1.2 }, body = { mass = 20 } }
  for _, side in ipairs { -0.4, 0.4 } do
    scene.add { parent = barrel, position = vec3(0, side, 0), color = "dimgray",
      mesh = { shape = "cylinder", radius = 0.36, height = 0.1 } }
  end
end

function on_scene_start() send_barrel() end
function start() task.every(8, scene.restart) end
function on_press(name)
  if name == "space" then send_barrel() end
end
