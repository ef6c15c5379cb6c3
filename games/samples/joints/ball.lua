-- Watch: a chain of ball joints swings a wrecking ball into a wall. A ball joint holds two bodies together at one point and
-- lets them turn any way about it. Space pushes the ball; all is set up again after a while.
scene.add { name = "camera", position = vec3(6, 3.6, 7), rotation_degrees = vec3(-7, 36, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkkhaki",
  mesh = { shape = "box", size = vec3(20, 0.2, 10) }, body = "static" }
local hook = scene.add { name = "hook", position = vec3(0, 6, 0), color = "black",
  mesh = { shape = "box", size = vec3(0.3, 0.3, 0.3) }, body = "static" }

-- The chain begins aslant, each link tied by its upper end to the lower end of the one before.
local length, aslant = 0.5, quat.axis_angle(vec3.back, math.rad(-70))
local function hang(above, at, name, shape, mass, height)
  local node = scene.add { name = name, position = hook.position + aslant * vec3(0, -at - height / 2, 0), rotation = aslant,
    material = { color = "dimgray", metalness = 0.6, roughness = 0.4 }, mesh = shape, body = { mass = mass } }
  joint.ball { a = node, b = above, anchor = vec3(0, height / 2, 0) }
  return node
end
local last = hook
for i = 1, 8 do
  last = hang(last, (i - 1) * length, "link " .. i, { shape = "capsule", radius = 0.07, height = length }, 2, length)
end
local ball = hang(last, 8 * length, "ball", { shape = "sphere", radius = 0.5 }, 200, 1)

for row = 0, 5 do
  for i = 1, 5 do
    scene.add { name = "brick", position = vec3(1.6, row * 0.4 + 0.2, (i - 3 + row % 2 / 2) * 0.7), color = "indianred",
      mesh = { shape = "box", size = vec3(0.4, 0.4, 0.68) }, body = { density = 600, friction = 0.7 } }
  end
end

function start() task.every(10, scene.restart) end
function on_press(name)
  if name == "space" then ball.body:apply_impulse(vec3(300, 0, random.between(-200, 200))) end
end
