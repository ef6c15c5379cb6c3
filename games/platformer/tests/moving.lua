-- How the player moves, through the keys that a person presses.
local function begin()
  wait(0.2)
  click("Play")
  wait(0.3)
  local player = scene.get("player")
  return player, player.behaviours.character, player.behaviours.player
end

-- An empty field high above the level, its top at y = 100, and the player in its middle.
local HIGH = 100
local function begin_on_a_field(size)
  local player, character, steering = begin()
  scene.add { name = "field", position = vec3(0, HIGH - 0.5, 0), body = "static", mesh = { shape = "box", size = vec3(size or 100, 1, size or 100) } }
  player:teleport(vec3(0, HIGH + 0.9, 0))
  wait(0.5)
  return player, character, steering
end

-- A ramp that rises ahead (along -z) from z = -3.
local function ramp(degrees)
  local angle, length = math.rad(degrees), 16
  local along, up = vec3(0, math.sin(angle), -math.cos(angle)), vec3(0, math.cos(angle), math.sin(angle))
  scene.add { name = "test ramp", position = vec3(0, HIGH, -3) + along * (length / 2) - up * 0.2, rotation_degrees = vec3(degrees, 0, 0),
    body = "static", mesh = { shape = "box", size = vec3(4, 0.4, length) } }
end

test("walking covers speed times time", function()
  local player, _, steering = begin_on_a_field()
  press("forward")
  wait(0.2)
  local from = player.position
  wait(2)
  expect(player.position:distance(from)):near(steering.speed * 2, 0.01)
end)

test("two keys at once are no faster than one", function()
  local player, _, steering = begin_on_a_field()
  press("forward")
  press("right")
  wait(0.2)
  local last = player.position
  for _ = 1, 60 do
    wait(0)
    expect(player.position:distance(last)):below(steering.speed * time.tick_seconds + 1e-6)
    last = player.position
  end
end)

test("a jump reaches jump_height within 3 percent", function()
  local player, character = begin_on_a_field()
  local ground, top = player.position.y, 0
  press("jump")
  wait_until(function()
    top = math.max(top, player.position.y - ground)
    return top > 0.5 and character.is_grounded
  end, 3)
  expect(top):near(character.jump_height, 0.03 * character.jump_height)
end)

test("a short press is a low jump", function()
  local player, character = begin_on_a_field()
  local ground, top = player.position.y, 0
  tap("jump", 0.05)
  for _ = 1, 60 do
    wait(0)
    top = math.max(top, player.position.y - ground)
  end
  expect(top):above(0.2)
  expect(top):below(0.6 * character.jump_height)
end)

-- Walks over the edge of a small field and presses jump so many ticks after the ground was lost; did it jump?
local function jumps_after_the_edge(ticks)
  local _, character = begin_on_a_field(6)
  press("forward")
  wait_until(function() return not character.is_grounded end, 3)
  for _ = 1, ticks do wait(0) end
  tap("jump", 0.3)
  for _ = 1, 3 do wait(0) end
  return character.velocity.y > 0
end

test("coyote time: just after the edge a jump still works", function()
  expect(jumps_after_the_edge(3)):equals(true)
end)

test("coyote time: long after the edge it does not", function()
  expect(jumps_after_the_edge(8)):equals(false)
end)

-- Falls from two metres and presses jump so many ticks before the ground; did it jump?
local function jumps_before_the_ground(ticks)
  local player, character = begin_on_a_field()
  local function drop()
    player:teleport(vec3(0, HIGH + 3, 0))
    character:stop()
  end
  local count = 0
  drop()
  repeat
    wait(0)
    count = count + 1
  until character.is_grounded
  drop()
  for _ = 1, count - ticks do wait(0) end
  press("jump")
  for _ = 1, ticks + 3 do wait(0) end
  return character.velocity.y > 0
end

test("jump buffer: just before the ground a jump already counts", function()
  expect(jumps_before_the_ground(4)):equals(true)
end)

test("jump buffer: long before the ground it does not", function()
  expect(jumps_before_the_ground(10)):equals(false)
end)

test("a ramp of 30 degrees is walked", function()
  local player = begin_on_a_field()
  ramp(30)
  press("forward")
  wait(2.5)
  expect(player.position.y):above(HIGH + 4)
end)

test("a ramp of 60 degrees is not", function()
  local player = begin_on_a_field()
  ramp(60)
  press("forward")
  wait(2.5)
  expect(player.position.y):near(HIGH + 0.86, 0.05)
end)

test("steps of 0.35 m are climbed at full speed", function()
  local player, _, steering = begin_on_a_field()
  for i = 1, 8 do
    scene.add { name = "test step", position = vec3(0, HIGH + 0.35 * i / 2, -3 - 0.9 * i), body = "static",
      mesh = { shape = "box", size = vec3(4, 0.35 * i, 0.9) } }
  end
  press("forward")
  wait(0.2)
  local from = player.position
  wait(1.5)
  local way = player.position - from
  expect(way:with_y(0):length()):near(steering.speed * 1.5, 0.01)
  expect(way.y):near(8 * 0.35, 0.02)
end)
