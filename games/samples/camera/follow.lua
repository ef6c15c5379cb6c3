-- Watch: arrow keys drive the ball, and the camera follows: it is a behaviour from the standard scripts, given by its
-- name. Change its `distance` and save.
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkseagreen",
  mesh = { shape = "box", size = vec3(40, 0.2, 40) }, body = "static" }
for i = 1, 30 do
  scene.add { name = "rock " .. i, position = random.in_sphere(18):with_y(0.3), rotation_degrees = vec3(0, random.between(0, 360), 0),
    color = "slategray", mesh = { shape = "box", size = vec3(1, random.between(0.5, 2), 1) }, body = "static" }
end
local ball = scene.add { name = "ball", position = vec3(0, 0.5, 0), color = "tomato",
  mesh = { shape = "sphere", radius = 0.4 }, body = { mass = 2, angular_damping = 0.8 } }
scene.add { name = "camera", position = vec3(0, 3, 6), camera = {},
  behaviours = { follow_camera = { target = ball, distance = 6, height = 2.5 } } }

function update(dt)
  local view = scene.camera
  local ahead = view.forward:with_y(0):normalized()
  local wish = view.right * input.axis("left", "right") + ahead * input.axis("down", "up")
  ball.body:apply_force(wish:clamped(1) * 16)
end
