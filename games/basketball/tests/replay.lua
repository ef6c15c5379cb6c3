-- The last throw, seen again.
local function replay() return scene.get("replay").behaviours.replay end
local function ball() return scene.get("ball").behaviours.ball end
local function picture() return scene.get("ball/picture") end

local function throw(velocity)
  click("Play")
  wait(0.1)
  ball():throw(velocity)
end

test("the replay leads the picture along the way that the ball went, and the ball stays in the hand", function()
  throw(vec3(0.3, 6, -2))
  local way = {}
  while ball().state == "flying" do
    wait(0)
    table.insert(way, picture().world_position)
  end
  tap("replay")
  wait(0.05)
  expect(replay().is_playing):equals(true)
  local seen, farthest = 0, 0
  while replay().is_playing do
    local nearest = math.huge
    for _, place in ipairs(way) do nearest = math.min(nearest, place:distance(picture().world_position)) end
    farthest = math.max(farthest, nearest)
    seen = seen + 1
    expect(scene.get("ball").position):equals(ball().home)
    wait(0)
  end
  expect(farthest):below(0.1)         -- between two ticks of at most 7 m/s
  local shown = #way - replay().leave_out * 60
  expect(seen):near(shown / replay().speed, 6)   -- slower than it was
  expect(picture().position):equals(vec3.zero)
end)

test("there is no replay before a throw, nor while the ball flies", function()
  click("Play")
  wait(0.1)
  tap("replay")
  wait(0.05)
  expect(replay().is_playing):equals(false)
  ball():throw(vec3(0, 5, 0))
  wait(0.2)
  tap("replay")
  wait(0.05)
  expect(replay().is_playing):equals(false)
end)

test("the clock stands and nothing is thrown while the replay runs; any press ends it", function()
  throw(vec3(0, 6, -2))
  wait_until(function() return ball().state == "held" end)
  tap("replay")
  wait(0.05)
  local seconds = scene.get("match").behaviours.match.seconds_left
  wait(1)
  expect(replay().is_playing):equals(true)
  expect(scene.get("match").behaviours.match.seconds_left):equals(seconds)
  tap("throw")
  wait(0.05)
  expect(replay().is_playing):equals(false)
  expect(ball().state):equals("held")
end)

test("a great basket is shown again by itself", function()
  click("Play")
  wait(0.1)
  for i = 1, 3 do                     -- the third one in a row counts three times
    expect(replay().is_playing):equals(false)
    ball():throw(vec3.zero)
    scene.get("ball"):teleport(vec3(0, 3.6, -4.2))
    wait_until(function() return ball().state == "held" end)
  end
  expect(replay().is_playing):equals(true)
end)
