-- Watch: lines, arrows, marks, shapes and words in the world, for as long as they are asked for: a tick from update(), a
-- picture from frame(). They are the quickest way to see what a script thinks.
scene.add { name = "camera", position = vec3(0, 2.5, 7), rotation_degrees = vec3(-14, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "slategray", mesh = { shape = "box", size = vec3(10, 0.2, 6) } }

local trail = {}

function update(dt)
  local at = vec3(2 * math.cos(time.now), 1 + 0.5 * math.sin(3 * time.now), 2 * math.sin(time.now))
  trail[#trail + 1] = at
  if #trail > 90 then table.remove(trail, 1) end
  draw.path(trail, "orange")
  draw.point(at, 0.1, "white")
  draw.arrow(vec3.zero, at, "lime")
  draw.text(at + vec3(0, 0.3, 0), ("height %.2f m"):format(at.y), "white", 28)
  log.watch("height, m", at.y)                                              -- a line at the edge of the screen
end

function frame(dt)
  local turned = quat.axis_angle(vec3.up, time.now)
  for i, shape in ipairs { "box", "sphere", "capsule", "cylinder", "cone", "torus" } do
    draw.shape(shape, vec3((i - 3.5) * 1.4, 0.6, -2), turned, color.hsv(i / 6, 0.5, 1))
  end
end
