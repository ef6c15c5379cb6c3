-- A round from the title to the end.
local function ball() return scene.get("ball").behaviours.ball end

test("without input nothing is thrown, scored or finished", function()
  wait(65)
  expect(game.is_finished):equals(false)
  expect(game.report.score):equals(0)
  expect(game.report.throws):equals(0)
end)

test("the title takes no throws", function()
  wait(0.1)
  point_at(640, 620)                  -- beside all buttons
  press("pointer")
  point_at(640, 700, 0.2)
  release("pointer")
  wait(0.1)
  expect(ball().state):equals("held")
  expect(game.report.throws):equals(0)
end)

test("a round lasts a minute, and then the game is finished", function()
  click("Play")
  wait(59.5)
  expect(game.is_finished):equals(false)
  wait(2)
  expect(game.is_finished):equals(true)
end)

test("a ball in the air at the end still counts", function()
  click("Play")
  wait(59.5)
  point_at(640, 380)
  press("pointer")
  point_at(640, 380 + 168, 0.2)
  release("pointer")
  wait(0.5)
  expect(game.is_finished):equals(false)
  expect(time.scale):below(1)
  wait_until(function() return game.is_finished end, 10)   -- after a replay, since it was great
  expect(game.is_finished):equals(true)
  expect(time.scale):equals(1)
  expect(game.report.score):equals(3)
end)

-- One that touches nothing: 1 more than the spot's own points.
local function basket()
  ball():throw(vec3.zero)
  scene.get("ball"):teleport(vec3(0, 3.6, -4.2))
  wait_until(function() return ball().state == "held" end)
end

test("a streak makes points count up to three times, and a miss ends it", function()
  click("Play")
  wait(0.1)
  local match, expected = scene.get("match").behaviours.match, 0
  for i = 1, 4 do
    expected = expected + (match:spot().points + 1) * math.min(i, 3)
    basket()
    expect(game.report.score):equals(expected)
  end
  ball():throw(vec3(0, 0, 1))
  wait_until(function() return ball().state == "held" end)
  expected = expected + match:spot().points + 1
  basket()
  expect(game.report.score):equals(expected)
  expect(game.report.streak):equals(4)
end)

test("who still aims when the time is up throws no more, and the arc goes", function()
  wait(0.1)
  click("Play")
  wait(59.5)
  point_at(640, 380)
  press("pointer")
  point_at(640, 548, 0.2)
  wait(0.2)
  expect(scene.get("arc").children[1].visible):equals(true)
  wait(1)
  expect(scene.get("arc").children[1].visible):equals(false)
  release("pointer")
  wait(0.2)
  expect(ball().state):equals("held")
end)

test("a basket leads to the next spot, a miss does not", function()
  click("Play")
  wait(0.1)
  local homes = {}
  for i = 1, 7 do
    homes[i] = ball().home
    ball():throw(vec3(0, 0, 1))
    wait_until(function() return ball().state == "held" end)
    expect(ball().home):equals(homes[i])
    basket()
  end
  expect(homes[2]:distance(homes[1])):above(1)
  expect(homes[7]):equals(homes[1])   -- six spots, and round again
end)

test("the next round starts from nothing", function()
  click("Play")
  wait(0.1)
  basket()
  wait(63)
  expect(game.report.score):equals(3)
  click("Play again")
  wait(0.1)
  expect(game.report.score):equals(0)
  expect(ball().state):equals("held")
  expect(scene.get("ball").behaviours.aim.is_allowed):equals(true)
end)
