-- The plates on their hinges.
local function play()
  click("Play")
  wait(0.1)
  return scene.get("ball"), scene.get("ball").behaviours.ball
end

-- A hard throw straight at a plate, from two metres in front of it.
local function hit(name, speed)
  local node, ball = play()
  local plate = scene.get(name)
  ball:throw(vec3(0, 1, -speed))
  node:teleport(plate.position + vec3(0, 0, 2))
  return plate
end

test("a plate that was hit gives its point once, swings and comes back", function()
  local plate = hit("plate 1", 8)
  local hinge, widest = plate:joint("hinge"), 0
  for _ = 1, 60 do
    wait(0)
    widest = math.max(widest, math.abs(hinge.angle_degrees))
  end
  expect(widest):above(10)
  wait(8)
  expect(math.abs(hinge.angle_degrees)):below(2)
  expect(hinge.is_broken):equals(false)
  expect(game.report.score):equals(1)
end)

test("a plate at rest stays at rest", function()
  local plate = scene.get("plate 3")
  wait(3)
  expect(math.abs(plate:joint("hinge").angle_degrees)):below(0.5)
  expect(plate:joint("hinge").is_broken):equals(false)
end)

test("the golden plate breaks off once and gives its points once", function()
  local plate = hit("plate 3", 9)
  wait(1)
  expect(plate:joint("hinge").is_broken):equals(true)
  expect(game.report.score):equals(2 + 5)
  wait(3)
  expect(plate.position.y):below(1)
  expect(game.report.score):equals(2 + 5)
end)

test("a soft hit does not break it", function()
  local plate = hit("plate 3", 2.5)
  wait(1.5)
  expect(plate:joint("hinge").is_broken):equals(false)
end)

test("a new round hangs it up again", function()
  hit("plate 3", 9)
  wait(63)
  expect(game.is_finished):equals(true)
  click("Play again")
  wait(1)
  local plate = scene.get("plate 3")
  expect(plate:joint("hinge").is_broken):equals(false)
  expect(plate.position.y):above(2.5)
end)
