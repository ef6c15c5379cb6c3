-- scripts/std/platform.lua
local function platform(options)
  return scene.add { name = "platform", body = "kinematic", mesh = "box", behaviours = { platform = options } }
end

test("it reaches its other place, rests, and comes home", function()
  local node = platform { travel = vec3(4, 2, 0), seconds = 2, wait = 1 }
  wait(0.5)
  expect(node.position):near(vec3.zero, 1e-9)
  wait(3)
  expect(node.position):near(vec3(4, 2, 0), 1e-6)
  wait(3)
  expect(node.position):near(vec3.zero, 1e-6)
end)

test("it turns at turn_speed", function()
  local node = platform { turn_speed = 0.5 }
  wait(0.1)
  local before = node.right
  wait(1)
  expect(node.right:angle(before)):near(0.5, 1e-6)
end)

test("it carries a crate", function()
  local node = scene.add { name = "platform", body = "kinematic", mesh = { shape = "box", size = vec3(4, 1, 4) },
    behaviours = { platform = { travel = vec3(5, 0, 0), seconds = 3, wait = 0.2 } } }
  local crate = scene.add { name = "crate", position = vec3(0, 1, 0), mesh = "box", body = { mass = 5, friction = 1 } }
  wait(3.5)
  expect(crate.position.x - node.position.x):near(0, 0.2)
end)
