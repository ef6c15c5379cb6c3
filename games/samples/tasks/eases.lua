-- Watch: the same way in the same time, and only the ease differs. A tween may change any number, vector or
-- colour, and `back` with `times` makes it go on for ever.
scene.add { name = "camera", position = vec3(0, 0, 9), camera = {} }
local eases = { "linear", "in", "out", "in_out", "out_back", "out_bounce" }
local balls = {}
for i, ease in ipairs(eases) do
  balls[i] = scene.add { name = ease, position = vec3(-3, 3.5 - i, 0), color = color.hsv(i / #eases, 0.6, 0.95),
    mesh = { shape = "sphere", radius = 0.3 } }
end

function start()
  for i, ease in ipairs(eases) do
    tween(balls[i], 1.5, { position = balls[i].position:with_x(4) }, { ease = ease, back = true, times = math.huge })
  end
end

function update(dt)
  for i, ease in ipairs(eases) do
    draw.line(vec3(-3, 3.5 - i, -0.4), vec3(4, 3.5 - i, -0.4), "gray")
    draw.text(vec3(-5.6, 3.7 - i, 0), ease)
  end
end
