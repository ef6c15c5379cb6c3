-- Watch: balls circle in a funnel, faster and faster, and fall through its hole. A mesh collider is the model's own
-- triangles, with every hollow and hole; it works on what does not fall. Space sends a handful the other way round.
scene.add { name = "camera", position = vec3(0, 4.4, 4.6), rotation_degrees = vec3(-35, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "#2d3b45",
  mesh = { shape = "box", size = vec3(16, 0.2, 10) }, body = "static" }

-- A static body takes the triangles of its model. A dynamic one would take the hull around it, which has no hole.
scene.add { name = "funnel", position = vec3(0, 2.6, 0), color = "lightseagreen", mesh = { shape = "mesh", file = "funnel.glb" },
  body = { type = "static", friction = 0.4 } }

local function send(direction)
  local side = random.between(1.9, 2)
  local ball = scene.add { position = vec3(side, 2.5, 0), color = color.hsv(random.between(0, 0.2), 0.8, 1),
    mesh = { shape = "sphere", radius = 0.1 },
    body = { mass = 0.1, velocity = vec3(0, 0, direction * random.between(1.6, 2)) } }
  task.after(20, ball.destroy, ball)
end

function start() task.every(0.8, send, -1) end
function on_press(name)
  if name ~= "space" then return end
  for i = 1, 6 do task.after(i * 0.2, send, 1) end
end
