-- Watch: press on a box, and a spring pulls the point you took towards the pointer. It works on anything with a body.
scene.add { name = "camera", position = vec3(0, 2.5, 8), rotation_degrees = vec3(-10, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(14, 0.2, 8) }, body = "static" }
for i = 1, 5 do
  scene.add { name = "box " .. i, tags = "box", position = vec3((i - 3) * 1.4, 0.4 + i * 0.05, 0), color = color.hsv(i / 6, 0.6, 0.95),
    mesh = { shape = "box", size = vec3(0.6, 0.6, 0.6) }, body = { mass = i } }
end

local held, grip, reach                            -- the node, where it was taken (in its space), how far from the eye

function on_press(name)
  if name ~= "pointer" then return end
  local hit = physics.pick { tags = "box" }
  if hit then held, grip, reach = hit.node, hit.node:to_local(hit.point), hit.distance end
end
function on_release(name)
  if name == "pointer" then held = nil end
end

function update(dt)
  if not held then return end
  local eye, far = scene.camera.camera:ray(input.pointer.x, input.pointer.y)
  local goal, at = eye + (far - eye):normalized() * reach, held:to_world(grip)
  -- 4 Hz and critically damped, whatever the mass: F = m (w^2 x - 2 w v), with w = 2 pi 4.
  local w = 2 * math.pi * 4
  held.body:apply_force(((goal - at) * (w * w) - held.body:velocity_at(at) * (2 * w)) * held.body.mass * 0.5, at)
  draw.line(at, goal, "white")
end
