-- Watch: three dolls are pushed over, and the two with lead in their bellies stand up again. Each is one body of three
-- colliders, whose offsets and densities say where its centre of mass is. The red one is of wood throughout. Space pushes.
scene.add { name = "camera", position = vec3(0, 1.7, 4.6), rotation_degrees = vec3(-12, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "seagreen",
  mesh = { shape = "box", size = vec3(9, 0.2, 5) }, body = { type = "static", friction = 0.8 } }

-- The parts' offsets are from the node's middle, which is the belly's. A density is in kg/m^3.
local function doll(name, x, lead, coat)
  return scene.add { name = name, position = vec3(x, 0.45, 0), tags = "doll",
    body = { friction = 0.8, angular_damping = 0.6, colliders = {
      { shape = "sphere", radius = 0.45, density = 600 },
      { shape = "sphere", radius = 0.26, offset = vec3(0, 0.62, 0), density = 600 },
      { shape = "cylinder", radius = 0.2, height = 0.1, offset = vec3(0, -0.35, 0), density = lead },
    } },
    children = {
      { name = "belly", material = { color = coat, opacity = 0.5 }, mesh = { shape = "sphere", radius = 0.45 } },
      { name = "weight", position = vec3(0, -0.35, 0), color = lead > 1000 and "dimgray" or "peru",
        mesh = { shape = "cylinder", radius = 0.2, height = 0.1 } },
      { name = "head", position = vec3(0, 0.62, 0), color = "bisque", mesh = { shape = "sphere", radius = 0.26 } },
      { name = "nose", position = vec3(0, 0.62, 0.26), color = "tomato", mesh = { shape = "sphere", radius = 0.05 } },
    } }
end
doll("left", -1.5, 11000, "royalblue")
doll("middle", 0, 11000, "gold")
doll("wooden", 1.5, 600, "crimson")

local function push()
  for _, node in ipairs(scene.tagged("doll")) do
    node.body:apply_impulse(vec3(1, 0, 0.6) * node.body.mass, node:to_world(vec3(0, 0.8, 0)))
  end
end

function start() task.every(12, scene.restart) end
function on_scene_start() task.after(1, push) end
function on_press(name)
  if name == "space" then push() end
end
