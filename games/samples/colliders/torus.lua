-- Watch: a torus has a hole that other things go through. So rings that lie in each other make a chain without any joint,
-- and rings that are thrown stay on the peg. Space throws another one.
scene.add { name = "camera", position = vec3(0.4, 2.2, 6), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkslategray",
  mesh = { shape = "box", size = vec3(12, 0.2, 6) }, body = "static" }

-- Each link lies across the one before: it is turned by 90 degrees about the chain, which is laid out along x.
local radius, thickness = 0.25, 0.12
for i = 0, 9 do
  scene.add { name = "link " .. i, position = vec3(-1.2 - i * 2 * (radius - thickness / 2), 4.2, 0),
    rotation_degrees = vec3(i % 2 * 90, 0, 0),
    material = { color = i == 0 and "dimgray" or "goldenrod", metalness = 0.7, roughness = 0.35 },
    mesh = { shape = "torus", radius = radius, thickness = thickness },
    body = { type = i == 0 and "static" or "dynamic", density = 3000, angular_damping = 0.3 } }
end

scene.add { name = "peg", position = vec3(2, 0.6, 0), color = "peru",
  mesh = { shape = "capsule", radius = 0.1, height = 1.4 }, body = "static" }
local function throw()
  local ring = scene.add { position = vec3(-0.5, 0.8, 1.5), color = color.hsv(random.between(0, 1), 0.6, 0.95),
    mesh = { shape = "torus", radius = 0.35, thickness = 0.1 },
    body = { mass = 0.3, friction = 0.8, angular_velocity = vec3(0, 6, 0),
      velocity = vec3(2.5, random.between(5.45, 5.75), random.between(-1.58, -1.42)) } }
  task.after(15, ring.destroy, ring)
end

function start() task.every(2, throw) end
function on_press(name)
  if name == "space" then throw() end
end
