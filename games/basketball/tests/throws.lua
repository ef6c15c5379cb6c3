-- Throws and what counts. The lift is 60 degrees, the ring 4.2 m in front of the ball and 1.55 m above it:
-- v^2 = g d^2 / (2 cos^2(lift) (d tan(lift) - h)), so 7.80 m/s, which is 0.56 of the way from 5 to 10 m/s.
local to_the_ring = 0.56 * 300
local ring = vec3(0, 3.05, -4.2)

local function play()
  click("Play")
  wait(0.1)
  return scene.get("ball"), scene.get("ball").behaviours.ball, scene.get("ball").behaviours.aim
end

local function pull(right, back)
  point_at(640, 380)
  press("pointer")
  point_at(640 + right, 380 + back, 0.2)
end

-- A throw that begins anywhere, with any velocity.
local function throw_from(position, velocity)
  local node, ball = play()
  ball:throw(velocity)
  node:teleport(position)
  return node, ball
end

test("a straight throw scores once, and one more since it touches nothing", function()
  play()
  pull(0, to_the_ring)
  release("pointer")
  wait(5)
  expect(game.report.score):equals(2 + 1)
  expect(game.report.throws):equals(1)
  expect(game.report.streak):equals(1)
end)

test("another pull gives another score", function()
  play()
  pull(0, to_the_ring / 2)
  release("pointer")
  wait(5)
  expect(game.report.score):equals(0)
  expect(game.report.throws):equals(1)
end)

test("the pull sets speed and direction in proportion, up to a limit", function()
  local _, _, aim = play()
  expect(aim:velocity_of(0, 0):length()):near(5, 1e-9)
  expect(aim:velocity_of(0, 150):length()):near(7.5, 1e-9)
  expect(aim:velocity_of(0, 300):length()):near(10, 1e-9)
  expect(aim:velocity_of(0, 900):length()):near(10, 1e-9)
  local ahead = vec3(0, 0, -1)
  local function turned(right) return math.deg(aim:velocity_of(right, 100):with_y(0):angle(ahead)) end
  expect(turned(0)):near(0, 1e-6)
  expect(turned(100)):near(15, 1e-6)
  expect(turned(300)):near(45, 1e-6)
  expect(turned(700)):near(45, 1e-6)
  expect(aim:velocity_of(100, 100).x):below(0)          -- a slingshot: pulled right, it flies left
end)

test("a pull that is let go where it began throws nothing", function()
  local _, ball = play()
  pull(0, 5)
  release("pointer")
  wait(0.5)
  expect(ball.state):equals("held")
  expect(game.report.throws):equals(0)
end)

test("the preview is the flight", function()
  local node, _, aim = play()
  pull(-60, to_the_ring)
  wait(0.05)
  local preview = aim:points_of(aim:velocity_of(-60, to_the_ring))
  release("pointer")
  for i, point in ipairs(preview) do
    wait(0.05)
    expect(node.position):near(point, 0.02)
  end
  expect(#preview):above(15)
end)

test("a ball from below does not count, nor when it falls back through the ring", function()
  throw_from(ring + vec3(0, -1, 0), vec3(0, 6, 0))
  wait(3)
  expect(game.report.score):equals(0)
end)

test("a ball that only peeps through the ring from below does not count", function()
  throw_from(ring + vec3(0, -1, 0), vec3(0, 4.6, 0))
  wait(3)
  expect(game.report.score):equals(0)
end)

test("a ball that falls past the ring does not count", function()
  throw_from(ring + vec3(0.38, 1, 0), vec3.zero)
  wait(3)
  expect(game.report.score):equals(0)
end)

test("a ball that rises and falls beside the ring does not count", function()
  throw_from(ring + vec3(-0.38, -1, 0), vec3(0, 6, 0))
  wait(3)
  expect(game.report.score):equals(0)
end)

test("a throw counts once, however often the ball goes through", function()
  local node = throw_from(ring + vec3(0, 0.6, 0), vec3.zero)
  wait(0.6)
  expect(game.report.score):equals(3)
  node:teleport(ring + vec3(0, 0.6, 0))
  wait(0.6)
  expect(game.report.score):equals(3)
end)

test("off the board it counts without the point for a clean throw", function()
  throw_from(vec3(0, 3.5, -3.9), vec3(0, 1.5, -1.6))
  wait(2)
  expect(game.report.score):equals(2)
end)

test("arrows lead the aim and space throws, from the spot towards the hoop", function()
  local _, ball, aim = play()
  press("left")
  wait(0.5)
  release("left")
  wait(0.1)
  local velocity = aim:velocity_of(aim.right, aim.back)
  expect(velocity.x):below(-0.3)
  expect(ball.state):equals("held")
  tap("space")
  wait(0.1)
  expect(ball.state):equals("flying")
  expect(scene.get("ball").body.velocity.x):near(velocity.x, 1e-4)
end)

test("a stick leads the aim, half as fast when it is pushed half way, and pad_a throws", function()
  local _, ball, aim = play()
  tap("up")                           -- shows the aim
  wait(0.1)
  local before = aim.back
  set_axis("pad_left_y-", "pad_left_y+", 0.5)
  wait(0.5)
  set_axis("pad_left_y-", "pad_left_y+", 0)
  wait(0.1)
  expect(aim.back - before):near(aim.keys_speed * 0.5 * 0.5, aim.keys_speed / 60)
  tap("pad_a")
  wait(0.1)
  expect(ball.state):equals("flying")
end)

test("the ball moves no farther in a tick than its speed allows, but back to its place", function()
  local node, ball = play()
  local throws = { to_the_ring, 60, 300, 140, 200 }
  for i, back in ipairs(throws) do
    pull((i - 3) * 60, back)
    release("pointer")
    wait(0.05)
    local last, speed, state = node.position, node.body.velocity:length(), ball.state
    while ball.state == "flying" do
      wait(0)
      local moved, faster = node.position:distance(last), math.max(speed, node.body.velocity:length())
      -- 5 mm more: within a tick it may still gain g/60 before it bounces.
      if ball.state == "flying" then expect(moved):below(faster / 60 + 0.005) end
      last, speed = node.position, node.body.velocity:length()
    end
    wait_until(function() return ball.state == "held" and not scene.get("replay").behaviours.replay.is_playing end)
    wait(0.05)
    expect(node.position):near(ball.home, 1e-9)
  end
end)
