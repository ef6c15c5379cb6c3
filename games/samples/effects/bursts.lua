-- Watch: sparks where the ball hits, the more the harder, and a trail that stays behind it. An emitter with rate 0
-- waits for burst(); it is moved to where it is needed.
scene.add { name = "camera", position = vec3(0, 2.5, 8), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(10, 0.2, 6) }, body = { type = "static", restitution = 0.85 } }
local sparks = scene.add { name = "sparks", particles = { rate = 0, life = 0.7, speed = 4, spread_degrees = 70,
  gravity_factor = 0.6, size = 0.1, color = "gold", color_end = color(1, 0.2, 0, 0), glow = 3 } }
local ball = scene.add { name = "ball", position = vec3(-3, 4, 0), color = "tomato", mesh = { shape = "sphere", radius = 0.3 },
  body = { mass = 1, velocity = vec3(1, 0, 0) },
  children = { { name = "trail", particles = { rate = 60, life = 0.8, speed = 0, size = 0.4, color = color(1, 0.6, 0.4, 0.5) } } } }

function ball.on_collision_enter(hit)
  sparks.position = hit.point
  sparks.particles:burst(math.ceil(math.clamp(hit.speed * 8, 1, 100)))
end

function update(dt)
  if math.abs(ball.position.x) > 4 then ball.body.velocity = ball.body.velocity:with_x(-ball.body.velocity.x) end
end
