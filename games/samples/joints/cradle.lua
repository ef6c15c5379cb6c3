-- Watch: as many balls fly off at one end as came at the other. Nothing but hinges, and balls that lose nothing where
-- they meet. Change `lifted` and save, then press F5.
local balls, lifted = 5, 1
local radius, length = 0.25, 2

scene.add { name = "camera", position = vec3(0, 2, 5), rotation_degrees = vec3(-4, 0, 0), camera = {} }
local beam = scene.add { name = "beam", position = vec3(0, 3, 0), color = "saddlebrown",
  mesh = { shape = "box", size = vec3(3, 0.1, 0.3) }, body = "static" }

-- A hair of a gap: the balls then meet one after the other, as real ones do.
for i = 1, balls do
  local top = vec3((i - (balls + 1) / 2) * (2 * radius + 0.001), 3, 0)
  local angle = i <= lifted and -0.7 or 0                               -- the pendulum's, rad
  local ball = scene.add { name = "ball " .. i, position = top + quat.axis_angle(vec3.back, angle) * vec3(0, -length, 0),
    rotation = quat.axis_angle(vec3.back, angle), mesh = { shape = "sphere", radius = radius },
    material = { color = "silver", metalness = 1, roughness = 0.2 },
    body = { mass = 1, restitution = 1, friction = 0, can_sleep = false } }
  joint.hinge { a = ball, b = beam, anchor = vec3(0, length, 0), axis = vec3.back }
end

function update(dt)
  for i = 1, balls do
    local ball = scene.get("ball " .. i)
    draw.line(ball:to_world(vec3(0, length, 0)), ball.position, "gray")
  end
end
