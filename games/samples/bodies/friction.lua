-- Watch: on a slope of 20 degrees, what has more friction than tan(20) = 0.36 stays, and the rest slides.
-- Change `slope_degrees` and save: the whole slope tilts, and the boxes wake.
local slope_degrees = 20

scene.add { name = "camera", position = vec3(0, 3.5, 8), rotation_degrees = vec3(-18, 0, 0), camera = {} }
scene.add { name = "slope", rotation_degrees = vec3(0, 0, -slope_degrees), color = "burlywood",
  mesh = { shape = "box", size = vec3(8, 0.2, 5) }, body = { type = "static", friction = 1 } }

-- The friction between two bodies is the product of theirs; the slope's is 1, so the box's own number holds.
for i = 1, 6 do
  local along = quat.euler_degrees(0, 0, -slope_degrees)
  scene.add { name = "box " .. i, tags = "box", position = along * vec3(-3, 0.3, (i - 3.5) * 0.8), rotation = along,
    color = color.hsv(i / 8, 0.7, 0.9), mesh = { shape = "box", size = vec3(0.4, 0.4, 0.4) },
    body = { friction = i * 0.1 } }
end

function update(dt)
  for _, box in ipairs(scene.tagged("box")) do
    draw.text(box.position + vec3(0, 0.5, 0), ("%.1f"):format(box.body.friction))
  end
end
