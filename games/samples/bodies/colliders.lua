-- Watch: the hammer is one body of two colliders. Thrown up, it turns about a point near its heavy end, and on its heavy
-- end it likes to land. F3 shows what the physics sees: shapes of its own, not the picture. Space throws it.
scene.add { name = "camera", position = vec3(0, 1.3, 3.4), rotation_degrees = vec3(-6, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(8, 0.2, 6) }, body = "static" }

-- A collider's offset is from the node's middle; density is kg in a cubic metre, and the mass follows from it.
local hammer = scene.add { name = "hammer", position = vec3(0.4, 0.7, 0), rotation_degrees = vec3(0, 0, 8),
  body = { colliders = {
    { shape = "box", size = vec3(0.3, 0.12, 0.12), offset = vec3(0, 0.45, 0), density = 7800 },     -- iron
    { shape = "cylinder", radius = 0.03, height = 0.9, density = 700 },                             -- wood
  } },
  children = {
    { name = "head", position = vec3(0, 0.45, 0), color = "slategray", mesh = { shape = "box", size = vec3(0.3, 0.12, 0.12) } },
    { name = "handle", color = "peru", mesh = { shape = "cylinder", radius = 0.03, height = 0.9 } },
  } }

physics.debug_view = "colliders"

local function throw()
  hammer:teleport(vec3(-0.6, 0.7, 0), quat.identity)
  hammer.body.velocity, hammer.body.angular_velocity = vec3(0.7, 4, 0), vec3(0, 0, -7)
end

function start()
  print(("the hammer has %.1f kg"):format(hammer.body.mass))
  throw()
  task.every(4, throw)
end
function on_press(name)
  if name == "space" then throw() end
end
