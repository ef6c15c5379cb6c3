-- Watch: a sun lights everything from one direction, a point light all around it, a spot in a cone along its node's
-- forward. Each is a component: put one on any node, and it goes where the node goes.
scene.add { name = "camera", position = vec3(0, 4, 8), rotation_degrees = vec3(-24, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "lightgray", mesh = { shape = "box", size = vec3(14, 0.2, 10) } }
for i = 1, 5 do
  scene.add { name = "pillar " .. i, position = vec3((i - 3) * 2, 0.8, -1), color = "white",
    mesh = { shape = "cylinder", radius = 0.3, height = 1.6 } }
end

scene.add { name = "evening sun", rotation_degrees = vec3(-35, 60, 0), light = { type = "sun", color = "#ffb080", brightness = 0.25 } }
local hub = scene.add { name = "hub", position = vec3(0, 0.6, 0) }
for i, name in ipairs { "tomato", "lime", "deepskyblue" } do
  local around = quat.axis_angle(vec3.up, i * 2 * math.pi / 3)
  scene.add { name = name, parent = hub, position = around * vec3(2.5, 0, 0), mesh = { shape = "sphere", radius = 0.12 },
    material = { color = name, glow = 2 }, light = { type = "point", color = name, brightness = 1, range = 5 } }
end
local lamp = scene.add { name = "lamp", position = vec3(0, 5, 3), rotation_degrees = vec3(-60, 0, 0),
  light = { type = "spot", color = "lightyellow", brightness = 1.5, range = 12, angle_degrees = 35 } }

function update(dt)
  hub:turn(vec3.up, dt)
  lamp.rotation_degrees = vec3(-60, 35 * math.sin(time.now), 0)
end
