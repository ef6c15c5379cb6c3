-- Watch: the blade hangs on a spring along its pole and spins about it, and neither changes the other. Space gives it
-- another push, around and up.
scene.add { name = "camera", position = vec3(0, 2, 5), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(6, 0.2, 6) }, body = "static" }
local pole = scene.add { name = "pole", position = vec3(0, 1.5, 0), color = "dimgray",
  mesh = { shape = "cylinder", radius = 0.06, height = 3 }, body = "static" }
local blade = scene.add { name = "blade", position = vec3(0, 1.8, 0), color = "orange",
  mesh = { shape = "box", size = vec3(1.8, 0.08, 0.25) }, body = { mass = 2, can_sleep = false } }

-- Each freedom has a table of its own: what is left out is free.
local bearing = joint.cylindrical { a = blade, b = pole, axis = vec3.up,
  slide = { min = -1.5, max = 1, spring = { frequency = 0.8, damping = 0.02 } },
  turn = { friction = 0.02 } }

local function push()
  blade.body:apply_angular_impulse(vec3(0, 2, 0))
  blade.body:apply_impulse(vec3(0, 3, 0))
end

function start() push() end
function on_press(name)
  if name == "space" then push() end
end

function update(dt)
  log.watch("slide, m", bearing.slide.position)
  log.watch("turn, degrees", bearing.turn.angle_degrees)
end
