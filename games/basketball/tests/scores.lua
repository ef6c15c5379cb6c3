-- The best rounds. A test begins with nothing stored.
local function play_a_round(baskets)
  click("Play")
  wait(0.2)
  local ball = scene.get("ball").behaviours.ball
  for _ = 1, baskets do
    ball:throw(vec3.zero)
    scene.get("ball"):teleport(vec3(0, 3.6, -4.2))
    wait_until(function() return ball.state == "held" end)
  end
  wait_until(function() return game.is_finished and is_on_screen("Play again") end, 90)
end

test("a round's points are stored at its end, with the name that is written", function()
  play_a_round(1)
  expect(is_on_screen("New record!")):equals(true)
  expect(storage.load("scores")[1].points):equals(3)
  click("Your name")
  for _ = 1, 16 do tap("backspace") wait(0.05) end
  type_text("Ada")
  wait(0.1)
  expect(storage.load("scores")[1].name):equals("Ada")
end)

test("a round without points is no record", function()
  play_a_round(0)
  expect(is_on_screen("Time!")):equals(true)
  expect(storage.load("scores", {})):equals({})
end)

test("the five best are kept, the best first", function()
  local scores = require "scores"
  for _, points in ipairs { 10, 30, 20, 50, 5, 40 } do scores.add(points) end
  local kept = {}
  for i, entry in ipairs(storage.load("scores")) do kept[i] = entry.points end
  expect(table.concat(kept, " ")):equals("50 40 30 20 10")
  scores.add(7)
  expect(scores.latest):equals(nil)
end)

test("the title shows the best rounds", function()
  play_a_round(1)
  click("Title")
  wait(0.2)
  expect(is_on_screen("Best rounds")):equals(true)
  expect(is_on_screen("1.  You  3")):equals(true)
end)
