-- Watch: a cone on its side does not roll away, it rolls around its tip, the slender one in the wider circle. On the
-- slope it swings to and fro, as a pendulum that lies down. Space starts them again.
scene.add { name = "camera", position = vec3(0.2, 3, 4.2), rotation_degrees = vec3(-36, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "midnightblue",
  mesh = { shape = "box", size = vec3(10, 0.2, 6) }, body = { type = "static", friction = 1 } }
local slope = scene.add { name = "slope", position = vec3(1.9, 0.5, -0.5), rotation_degrees = vec3(15, 0, 0), color = "steelblue",
  mesh = { shape = "cylinder", radius = 1.3, height = 0.1 }, body = { type = "static", friction = 1 } }

-- Laid down with its tip at a place, its side along the ground's x, and rolling with so many rad/s about that side.
local function cone(name, tip, ground, radius, height, roll, color)
  local half_angle = math.atan(radius / height)
  local axis = ground * vec3(math.cos(half_angle), math.sin(half_angle), 0)           -- from the tip to the base
  local turning = ground * vec3(roll, 0, 0)
  return scene.add { name = name, position = tip + axis * (height / 2), color = color,
    rotation = ground * quat.axis_angle(vec3.back, math.pi / 2 + half_angle),
    mesh = { shape = "cone", radius = radius, height = height },
    body = { density = 500, friction = 1, can_sleep = false, angular_velocity = turning,
      velocity = turning:cross(axis * (height * 0.75)) } }       -- its centre of mass is three quarters from the tip
end
cone("slender", vec3(-1.5, 0, 0.1), quat.identity, 0.25, 1.1, 4, "gold")
cone("wide", vec3(0.3, 0, 1.3), quat.identity, 0.3, 0.5, 3, "tomato")
cone("swinging", slope:to_world(vec3(0, 0.05, -0.5)), slope.rotation * quat.axis_angle(vec3.up, -0.4), 0.3, 1, 0, "limegreen")
scene.add { name = "standing", position = vec3(0, 0.4, -1.2), color = "orange", mesh = { shape = "cone", radius = 0.3, height = 0.8 },
  body = { density = 500 } }

-- Each draws where the middle of its base was.
local trails = { slender = {}, wide = {}, swinging = {} }
function update(dt)
  for name, trail in pairs(trails) do
    local node = scene.get(name)
    table.insert(trail, node:to_world(vec3(0, -node.mesh.height / 2, 0)))
    if #trail > 300 then table.remove(trail, 1) end
    draw.path(trail, node.color)
  end
end

function on_press(name)
  if name == "space" then scene.restart() end
end
