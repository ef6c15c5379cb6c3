-- scripts/std/follow_camera.lua
local function target(position)
  return scene.add { name = "target", position = position or vec3.zero, mesh = "sphere" }
end

local function camera(node, options)
  options.target = node
  local eye = scene.add { name = "eye", camera = {}, behaviours = { follow_camera = options } }
  wait(0.1)
  return eye
end

test("it goes behind its target and looks at it", function()
  local node = target()
  local eye = camera(node, { distance = 7, height = 3 })
  wait(2)
  expect(eye.position):near(vec3(0, 3, 7), 0.01)
  expect(eye.forward):near(vec3(0, -3, -7):normalized(), 0.001)
end)

test("it keeps up with a target that moves", function()
  local node = target()
  local eye = camera(node, { distance = 7, height = 3, smoothing = 0.1 })
  for _ = 1, 120 do
    node.position = node.position + vec3(0, 0, -0.1)                  -- 6 m/s
    wait(0)
  end
  expect(eye.position.z - node.position.z):near(7 + 0.6, 0.2)         -- behind by speed times smoothing
end)

test("it comes closer rather than going into a wall", function()
  local node = target()
  scene.add { name = "wall", position = vec3(0, 0, 4), mesh = { shape = "box", size = vec3(10, 10, 1) }, body = "static" }
  local eye = camera(node, { distance = 7, height = 0 })
  wait(1)
  expect(eye.position.z):near(3.5 - 0.25, 0.01)
end)

test("it swings round when the target walks sideways, and not when it walks straight", function()
  local node = target()
  local eye = camera(node, { turn_speed = 0.5 })
  for _ = 1, 60 do
    node.position = node.position + vec3(0, 0, -0.1)
    wait(0)
  end
  expect(eye.right.z):near(0, 0.01)
  for _ = 1, 60 do
    node.position = node.position + eye.right * 0.1
    wait(0)
  end
  expect(eye.right.z):near(math.sin(0.5), 0.02)                       -- half a radian to the right
end)

test("look() turns it about its target as far as it is told, within bounds, and holds for a while", function()
  local node = target()
  local eye = camera(node, { distance = 6, height = 0, turn_speed = 0.5, hold_seconds = 1, highest_degrees = 30 })
  local follow = eye.behaviours.follow_camera
  follow:look(math.pi / 2, 0)
  wait(1.5)
  expect(eye.forward):near(vec3.right, 0.001)
  follow:look(0, -math.rad(80))
  wait(1)
  expect(eye.position.y):near(6 * math.sin(math.rad(30)), 0.02)
  follow:look(1e-9, 0)
  local right = eye.right
  for _ = 1, 50 do
    node.position = node.position + eye.right * 0.1
    wait(0)
  end
  expect(eye.right:angle(right)):below(0.01)
  for _ = 1, 60 do
    node.position = node.position + eye.right * 0.1
    wait(0)
  end
  expect(eye.right:angle(right)):above(0.3)
end)
