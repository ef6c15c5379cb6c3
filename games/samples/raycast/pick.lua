-- Watch: point at a box. The arrow is the surface's normal where the line of sight meets it; a press kicks the
-- box there, so it turns as a real one would.
scene.add { name = "camera", position = vec3(0, 3, 9), rotation_degrees = vec3(-12, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(14, 0.2, 8) }, body = "static" }
for i = 1, 9 do
  scene.add { name = "box " .. i, tags = "box", position = vec3((i - 5) * 1.3, 0.5 + i % 3, 0),
    color = color.hsv(i / 9, 0.5, 0.9), mesh = "box", body = { mass = 1 } }
end

function update(dt)
  local hit = physics.pick { tags = "box" }                 -- the first one under the pointer, or nil
  if not hit then return end
  draw.arrow(hit.point, hit.point + hit.normal, "red")
  draw.text(hit.point + vec3(0, 0.3, 0), ("%s, %.1f m away"):format(hit.node.name, hit.distance))
  if input.was_pressed("pointer") then hit.body:apply_impulse(hit.normal * -4, hit.point) end
end

-- A ray from any place into any direction: here straight down, to show how high each box is.
function late_update(dt)
  for _, box in ipairs(scene.tagged("box")) do
    local below = physics.raycast(box.position, vec3.down, 10, { ignore = box })
    if below then draw.line(box.position, below.point, "white") end
  end
end
