-- Watch: what comes into the blue box is lifted, and falls again outside. A trigger tells who is in it; on_trigger_stay
-- comes every tick, so a force there works as long as the body stays.
scene.add { name = "camera", position = vec3(0, 3, 9), rotation_degrees = vec3(-6, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(10, 0.2, 4) }, body = { type = "static", friction = 0.2 } }
local shaft = scene.add { name = "shaft", position = vec3(0, 2, 0), mesh = { shape = "box", size = vec3(2, 4, 2) },
  material = { color = "deepskyblue", opacity = 0.2 }, body = { type = "static", trigger = true } }
for i = 1, 6 do
  scene.add { name = "ball " .. i, position = vec3((i - 3.5) * 0.3, 0.3 + i * 0.4, (i % 3 - 1) * 0.4), color = color.hsv(i / 6, 0.6, 0.95),
    mesh = { shape = "sphere", radius = 0.2 }, body = { mass = 0.5, damping = 0.6, restitution = 0.4 } }
end

function shaft.on_trigger_stay(hit)
  local body = hit.body
  body:apply_force(vec3.up * body.mass * 14)                                -- more than its weight, m * 9.81
end
