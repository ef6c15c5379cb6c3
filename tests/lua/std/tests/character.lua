-- scripts/std/character.lua, driven by its own functions. The walker is a capsule of 0.35 m radius, 1.7 m high.
local SPEED = 6
local STANDING = 0.86          -- m from the ground to the middle of a standing capsule, its skin included

local function box(position, size, options)
  local node = options or {}
  node.position, node.mesh = position, { shape = "box", size = size }
  node.body = node.body or "static"
  return scene.add(node)
end

-- The top of the floor is at y = 0.
local function floor() return box(vec3(0, -0.5, 0), vec3(200, 1, 200)) end

local function ticks(count) for _ = 1, count do wait(0) end end

-- A character that stands at that place of the ground.
local function walker(position, options)
  local node = scene.add {
    name = "walker", position = (position or vec3.zero) + vec3.up * STANDING, body = "kinematic",
    mesh = { shape = "capsule", radius = 0.35, height = 1.7 }, behaviours = { character = options or {} },
  }
  ticks(3)
  return node, node.behaviours.character
end

local function walk(character, velocity, count, each_tick)
  for i = 1, count do
    character:move(velocity)
    wait(0)
    if each_tick then each_tick(i) end
  end
end

local function highest_of_jump(node, character, cut_after)
  local ground, top = node.position.y, node.position.y
  character:jump()
  for i = 1, 90 do
    if i == cut_after then character:cut_jump() end
    wait(0)
    top = math.max(top, node.position.y)
  end
  return top - ground
end

-- A ramp that rises along +x from x = 2, three metres wide.
local function ramp(degrees, length)
  local angle = math.rad(degrees)
  local along, up = vec3(math.cos(angle), math.sin(angle), 0), vec3(-math.sin(angle), math.cos(angle), 0)
  return box(vec3(2, 0, 0) + along * (length / 2) - up * 0.25, vec3(length, 0.5, 3), { rotation_degrees = vec3(0, 0, degrees) })
end

test("it covers speed times time", function()
  floor()
  local node, character = walker()
  local from = node.position
  walk(character, vec3(SPEED, 0, 0), 120)
  expect(node.position):near(from + vec3(SPEED * 2, 0, 0), 1e-6)
end)

test("without move it stands still", function()
  floor()
  local node, character = walker()
  local from = node.position
  ticks(120)
  expect(node.position):near(from, 1e-6)
  expect(character.is_grounded):equals(true)
end)

test("a jump reaches jump_height within 3 percent", function()
  floor()
  local node, character = walker(vec3.zero, { jump_height = 1.5 })
  expect(highest_of_jump(node, character)):near(1.5, 0.045)
  expect(character.is_grounded):equals(true)
end)

test("a jump that is cut stays lower, and the next is full again", function()
  floor()
  local node, character = walker(vec3.zero, { jump_height = 1.5 })
  expect(highest_of_jump(node, character, 4)):below(0.9)
  expect(highest_of_jump(node, character)):near(1.5, 0.045)
end)

test("it lands with the speed of its fall and says so", function()
  floor()
  local node, character = walker(vec3(0, 3, 0), { gravity = 20 })
  local speed
  function node.on_land(v) speed = v end
  wait_until(function() return character.is_grounded end, 3)
  ticks(1)
  expect(speed):near(math.sqrt(2 * 20 * 3), 0.4)        -- m/s; a tick's worth of gravity
end)

-- Walks off a ledge and calls jump() in the nth tick of its fall; did it jump?
local function jumps_after(n, coyote_seconds)
  box(vec3(-5, -0.5, 0), vec3(10, 1, 4))
  local node, character = walker(vec3(-1, 0, 0), { coyote_seconds = coyote_seconds })
  while character.is_grounded do walk(character, vec3(SPEED, 0, 0), 1) end
  walk(character, vec3(SPEED, 0, 0), n - 1)
  character:jump()
  walk(character, vec3(SPEED, 0, 0), 1)
  return character.velocity.y > 1
end

test("coyote time: a jump counts until its last tick", function()
  expect(jumps_after(6, 6 * time.tick_seconds)):equals(true)
end)

test("coyote time: a tick later it does not", function()
  expect(jumps_after(7, 6 * time.tick_seconds)):equals(false)
end)

-- Calls jump() so many ticks before the first tick on the ground; did it jump then?
local function jumps_when_called(n, buffer_seconds)
  floor()
  local node, character = walker(vec3.zero, { buffer_seconds = buffer_seconds })
  local function drop()
    node:teleport(vec3(0, 3, 0))
    character:stop()
  end
  drop()
  local fall = 0                                         -- ticks
  repeat
    wait(0)
    fall = fall + 1
  until character.is_grounded
  drop()
  ticks(fall - n)
  character:jump()
  ticks(n)
  expect(character.is_grounded):equals(true)
  ticks(1)
  return character.velocity.y > 1
end

test("jump buffer: a jump called before the landing counts", function()
  expect(jumps_when_called(6, 6 * time.tick_seconds)):equals(true)
end)

test("jump buffer: one called a tick earlier does not", function()
  expect(jumps_when_called(7, 6 * time.tick_seconds)):equals(false)
end)

test("a ramp of 30 degrees is walked at full speed", function()
  floor()
  ramp(30, 20)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 60)                 -- well on to the ramp
  local from = node.position
  walk(character, vec3(SPEED, 0, 0), 60)
  expect(node.position:distance(from)):near(SPEED, 0.01)
  expect(node.position.y - from.y):near(SPEED * math.sin(math.rad(30)), 0.01)
end)

test("a ramp of 30 degrees is walked down without leaving it", function()
  floor()
  ramp(30, 20)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 150)
  walk(character, vec3(-SPEED, 0, 0), 120, function() expect(character.is_grounded):equals(true) end)
  expect(node.position.y):below(4.5)
end)

test("it stands still on a ramp of 40 degrees", function()
  floor()
  ramp(40, 20)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 90)
  local from = node.position
  ticks(120)
  expect(node.position):near(from, 1e-4)
end)

test("a ramp of 60 degrees is not walked", function()
  floor()
  ramp(60, 20)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 120)
  expect(node.position.y):below(STANDING + 0.05)
end)

test("a ramp of 60 degrees is not climbed by jumping, and slides off", function()
  floor()
  ramp(60, 20)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 240, function(i) if i % 20 == 0 then character:jump() end end)
  ticks(60)
  expect(node.position.y):below(STANDING + 0.05)
end)

-- Steps along +x from x = 2, each `rise` high and 0.8 m deep.
local function stairs(count, rise)
  for i = 1, count do box(vec3(2 + 0.8 * (i - 0.5), rise * i / 2, 0), vec3(0.8, rise * i, 3)) end
  box(vec3(2 + 0.8 * count + 10, rise * count / 2, 0), vec3(20, rise * count, 3))
end

test("steps of 0.35 m are climbed at full speed", function()
  floor()
  stairs(6, 0.35)
  local node, character = walker()
  local from = node.position
  walk(character, vec3(SPEED, 0, 0), 90, function() expect(character.is_grounded):equals(true) end)
  expect(node.position.x - from.x):near(SPEED * 1.5, 0.01)
  expect(node.position.y - from.y):near(6 * 0.35, 0.01)
end)

test("steps of 0.35 m are climbed however slowly, and never back", function()
  floor()
  stairs(2, 0.35)
  local node, character = walker(vec3(1.5, 0, 0))
  local last = node.position
  walk(character, vec3(0.5, 0, 0), 240, function()
    expect(node.position.x):above(last.x)
    expect(node.position.y):above(last.y - 1e-3)
    last = node.position
  end)
  expect(last.y - STANDING):near(0.7, 0.01)
end)

test("steps are walked down without a jump", function()
  floor()
  stairs(6, 0.35)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 100)
  walk(character, vec3(-SPEED, 0, 0), 100, function() expect(character.is_grounded):equals(true) end)
  expect(node.position.y):near(STANDING, 0.01)
end)

test("a step of 0.45 m is a wall", function()
  floor()
  stairs(1, 0.45)
  local node, character = walker()
  walk(character, vec3(SPEED, 0, 0), 120)
  expect(node.position.y):near(STANDING, 0.02)
  expect(node.position.x):below(2)
end)

test("seams of a tiled floor are not felt", function()
  for i = -2, 12 do box(vec3(i, -0.5, 0), vec3(1, 1, 1)) end
  local node, character = walker()
  local from = node.position
  walk(character, vec3(SPEED, 0, 0), 90, function() expect(node.position.y):near(from.y, 1e-5) end)
  expect(node.position.x - from.x):near(9, 1e-5)
end)

test("along a wall it keeps the speed that points along it", function()
  floor()
  for i = 0, 14 do box(vec3(i, 1, -1), vec3(1, 2, 1)) end           -- its face at z = -0.5, in blocks
  local node, character = walker()
  local from = node.position
  walk(character, vec3(4, 0, -4), 120)
  expect(node.position.x - from.x):near(8, 0.01)
  expect(node.position.z):near(-0.5 + 0.35, 0.02)
end)

test("in a corner it stands still", function()
  floor()
  box(vec3(1, 1, 0), vec3(1, 2, 10))
  box(vec3(0, 1, -1), vec3(10, 2, 1))
  local node, character = walker()
  walk(character, vec3(4, 0, -4), 60)
  local from = node.position
  walk(character, vec3(4, 0, -4), 60)
  expect(node.position):near(from, 1e-4)
end)

test("the fastest walker does not pass a thin wall", function()
  floor()
  box(vec3(10, 1, 0), vec3(0.01, 2, 10))
  local node, character = walker()
  walk(character, vec3(2000, 0, 0), 30)
  expect(node.position.x):below(10)
  expect(node.position.x):above(9.5)
end)

test("the longest fall does not pass a thin floor", function()
  box(vec3(0, -0.005, 0), vec3(10, 0.01, 10))
  local node, character = walker(vec3(0, 200, 0))
  wait_until(function() return character.is_grounded end, 20)
  expect(node.position.y):near(STANDING, 0.001)
end)

test("a ceiling ends a jump", function()
  floor()
  box(vec3(0, 2.5, 0), vec3(4, 1, 4))                               -- 0.3 m above its head
  local node, character = walker()
  expect(highest_of_jump(node, character)):near(0.29, 0.01)
end)

-- Rides for so many ticks; the largest distance between the rider and where the platform began to carry it.
local function slip(platform, node, count)
  local foothold = platform:to_local(node.position)
  local worst = 0
  for _ = 1, count do
    wait(0)
    worst = math.max(worst, node.position:distance(platform:to_world(foothold)))
  end
  return worst
end

local function platform(options, place)
  return scene.add { name = "platform", position = vec3(0, -0.25, 0) + (place or vec3.zero), body = "kinematic",
    mesh = { shape = "box", size = vec3(6, 0.5, 6) }, behaviours = { platform = options } }
end

test("a platform that goes sideways carries it", function()
  local lift = platform { travel = vec3(8, 0, 3), seconds = 2, wait = 0.5 }
  local node = walker()
  expect(slip(lift, node, 300)):below(1e-3)
end)

test("a platform that goes up and down carries it", function()
  local lift = platform { travel = vec3(0, 6, 0), seconds = 1.5, wait = 0.5 }
  local node, character = walker()
  expect(slip(lift, node, 240)):below(2e-3)
  expect(character.is_grounded):equals(true)
end)

test("a platform that turns carries it round", function()
  local wheel = platform { turn_speed = 1 }
  local node = walker(vec3(2, 0, 0))
  expect(slip(wheel, node, 300)):below(2e-3)
end)

test("who jumps straight up on a moving platform comes down on the same spot", function()
  local lift = platform { travel = vec3(20, 0, 0), seconds = 8, wait = 0.1 }
  local node, character = walker()
  ticks(220)                                                        -- its speed hardly changes now
  local foothold = lift:to_local(node.position)
  character:jump()
  ticks(5)
  wait_until(function() return character.is_grounded end, 3)
  expect(lift:to_local(node.position)):near(foothold, 0.35)
end)

test("a wall that moves into it pushes it away", function()
  floor()
  box(vec3(3, 1, 0), vec3(1, 2, 4), { name = "press", body = "kinematic", behaviours = { platform = { travel = vec3(-6, 0, 0), seconds = 2, wait = 0 } } })
  local node, character = walker()
  ticks(110)
  expect(node.position.x):below(-2)
  expect(character.is_grounded):equals(true)
end)

test("it pushes a crate no faster than it walks, and never passes into it", function()
  floor()
  local crate = box(vec3(2, 0.45, 0), vec3(0.9, 0.9, 0.9), { name = "crate", body = { mass = 25 } })
  local node, character = walker()
  walk(character, vec3(3, 0, 0), 120, function()
    expect(crate.body.velocity.x):below(3.2)
    expect(crate.position.x - node.position.x):above(0.45 + 0.35 - 0.02)
  end)
  expect(crate.position.x):above(4)
end)

test("a crate that is too heavy is a wall", function()
  floor()
  local crate = box(vec3(2, 0.45, 0), vec3(0.9, 0.9, 0.9), { name = "crate", body = { mass = 5000 } })
  local node, character = walker()
  walk(character, vec3(3, 0, 0), 60)
  expect(crate.position.x):near(2, 0.05)
end)

test("its weight presses on what it stands on", function()
  floor()
  local plank = box(vec3(0, 0.6, 0), vec3(8, 0.2, 1), { name = "plank", body = { mass = 20 } })
  joint.hinge { name = "pivot", a = plank, axis = vec3(0, 0, 1) }
  walker(vec3(2, 0.7, 0))
  ticks(60)
  expect(plank.right.y):below(-0.1)
end)

test("two runs are the same to the last digit", function()
  floor()
  stairs(6, 0.35)
  local node, character = walker()
  local places = {}
  for run = 1, 2 do
    node:teleport(vec3(0, STANDING, 0))
    character:stop()
    ticks(2)
    walk(character, vec3(5, 0, 0.3), 150, function(i) if i % 40 == 0 then character:jump() end end)
    places[run] = node.position
  end
  expect(places[2]):equals(places[1])
end)

test("launch() throws it to that height, from the ground and from a fall, and cut_jump() leaves it", function()
  floor()
  local node, character = walker()
  for _, from in ipairs { STANDING, STANDING + 3 } do
    node:teleport(vec3(0, from, 0))
    wait(0.2)
    local start, top = node.position.y, 0
    character:launch(4)
    wait(0.1)
    character:cut_jump()
    for _ = 1, 120 do
      wait(0)
      top = math.max(top, node.position.y)
    end
    expect(top - start):near(4, 0.02)
    expect(character.is_grounded):equals(true)
  end
end)

test("ground that turns about y turns who stands on it; tipping ground does not", function()
  local disc = scene.add { name = "disc", position = vec3(0, -0.5, 0), body = "kinematic", mesh = { shape = "box", size = vec3(9, 1, 9) },
    behaviours = { platform = { turn_speed = 0.8 } } }
  local node = walker(vec3(2, 0, 0))
  local ahead = disc.world_rotation:inverse() * node.forward
  wait(3)
  expect(disc.world_rotation:inverse() * node.forward):near(ahead, 1e-3)
  disc.behaviours.platform = nil
  local before = node.forward
  for _ = 1, 60 do
    disc:turn(vec3.right, 0.002)
    wait(0)
  end
  expect(node.forward):near(before, 1e-3)
end)

-- Walls around a heap of boxes that lie at random, some of them moving.
local function heap()
  floor()
  for _, place in ipairs { vec3(12, 5, 0), vec3(-12, 5, 0), vec3(0, 5, 12), vec3(0, 5, -12) } do
    box(place, vec3(place.x == 0 and 25 or 1, 12, place.z == 0 and 25 or 1))
  end
  for i = 1, 60 do
    local place = vec3(random.between(-11, 11), random.between(-0.3, 2.5), random.between(-11, 11))
    local size = vec3(random.between(0.3, 4), random.between(0.2, 2), random.between(0.3, 4))
    box(place, size, { rotation_degrees = vec3(random.between(-60, 60), random.between(0, 360), 0) })
  end
  for i = 1, 3 do
    box(vec3(0, 4 + 2 * i, 0), vec3(3, 0.4, 3), { body = "kinematic",
      behaviours = { platform = { travel = vec3(random.between(-7, 7), -1, random.between(-7, 7)), turn_speed = 1 } } })
    box(vec3(random.between(-11, 11), 6, random.between(-11, 11)), vec3(0.9, 0.9, 0.9), { body = { mass = 25 } })
  end
end

test("in a heap of anything it gets into nothing, out of nothing, and hangs nowhere", function()
  heap()
  local node, character = walker(vec3(0, 12, 0))
  local way, hangs = vec3.zero, 0
  for i = 1, 3000 do
    if i % 40 == 1 then way = random.direction():with_y(0) * 8 end
    if random.chance(0.03) then character:jump() end
    local before = node.position
    walk(character, way, 1)
    local place = node.position
    expect(place.y):above(0.8)
    expect(math.max(math.abs(place.x), math.abs(place.z))):below(11.5)
    hangs = place:distance(before) < 1e-4 and not character.is_grounded and hangs + 1 or 0
    expect(hangs):below(10)
    for _, hit in ipairs(physics.penetrations(character.shape, place, 0, { ignore = node })) do
      if hit.body.type == "static" then expect(hit.distance):above(-0.1) end   -- m, squeezed by what moves
    end
  end
end)
