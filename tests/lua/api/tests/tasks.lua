-- Tasks and tweens. A tick is 1/60 s; a test runs before the tick's tasks.
local tick = 1 / 60

test("task.after calls once, when its seconds are over", function()
  local at
  local begun = time.now
  task.after(0.5, function() at = time.now end)
  wait(1)
  expect(at - begun):near(0.5, tick + 1e-9)
end)

test("task.after hands its arguments on", function()
  local got
  task.after(0, function(...) got = table.pack(...) end, 1, nil, "three")
  wait(0.1)
  expect(got.n):equals(3)
  expect(got[3]):equals("three")
end)

test("task.every calls again and again without drifting", function()
  local count = 0
  task.every(0.1, function() count = count + 1 end)
  wait(5.05)
  expect(count):equals(50)
end)

test("a stopped task does not call", function()
  local count = 0
  local handle = task.every(0.1, function() count = count + 1 end)
  wait(0.35)
  expect(handle.is_done):equals(false)
  handle:stop()
  expect(handle.is_done):equals(true)
  local before = count
  wait(0.5)
  expect(count):equals(before)
end)

test("task.spawn waits in game time, and wait_until for a condition", function()
  local steps = {}
  local open = false
  task.spawn(function()
    wait(0.2)
    steps[1] = time.now
    wait_until(function() return open end)
    steps[2] = time.now
  end)
  local begun = time.now
  wait(1)
  expect(steps[1] - begun):near(0.2, tick + 1e-9)
  expect(steps[2]):equals(nil)
  open = true
  wait(0.1)
  expect(steps[2]):above(0)
end)

test("wait_until gives up after its timeout and says so", function()
  local answer, other
  task.spawn(function() answer = wait_until(function() return false end, 0.3) end)
  task.spawn(function() other = wait_until(function() return true end, 0.3) end)
  wait(0.6)
  expect(answer):equals(false)
  expect(other):equals(true)
end)

test("task.loop begins again when it ends", function()
  local rounds = 0
  local handle = task.loop(function()
    wait(0.1)
    rounds = rounds + 1
  end)
  wait(1.05)
  expect(rounds):above(7)
  expect(rounds):below(11)
  handle:stop()
end)

test("a handle can be waited for", function()
  local order = {}
  local first = task.spawn(function() wait(0.3) table.insert(order, "first") end)
  task.spawn(function() first:wait() table.insert(order, "second") end)
  wait(0.6)
  expect(table.concat(order, " ")):equals("first second")
end)

test("and_then follows", function()
  local followed
  task.after(0.1, function() end):and_then(function(word) followed = word end, "yes")
  wait(0.3)
  expect(followed):equals("yes")
end)

test("pausing holds tasks, and a bot's own waits go on", function()
  local done = false
  task.after(0.2, function() done = true end)
  time.paused = true
  local now = time.now
  wait(1)
  expect(done):equals(false)
  expect(time.now):equals(now)
  time.paused = false
  wait(0.3)
  expect(done):equals(true)
end)

test("time.step goes on by one tick while paused", function()
  time.paused = true
  wait(0.1)
  local before = time.tick
  time.step()
  wait(0.1)
  expect(time.tick - before):equals(1)
end)

test("a tween goes from where the value is to where it shall be, evenly", function()
  local node = scene.add { position = vec3(0, 2, 0) }
  local begun = time.now
  tween(node, 1, { position = vec3(6, 2, 0) })
  for _ = 1, 5 do
    wait(0.1)
    expect(node.position.x):near(6 * (time.now - begun), 6 * tick + 1e-6)
  end
  wait(0.7)
  expect(node.position):equals(vec3(6, 2, 0))
end)

test("eases begin at the start and end at the goal", function()
  for _, ease in ipairs { "linear", "in", "out", "in_out", "out_back", "out_bounce" } do
    local thing = { value = 3 }
    tween(thing, 0.3, { value = 5 }, { ease = ease })
    wait(0.5)
    expect(thing.value):near(5, 1e-9)
  end
end)

test("in lags behind and out hurries ahead", function()
  local slow, fast = { value = 0 }, { value = 0 }
  tween(slow, 1, { value = 1 }, { ease = "in" })
  tween(fast, 1, { value = 1 }, { ease = "out" })
  wait(0.5)
  expect(slow.value):near(0.25, 0.04)                       -- t^2
  expect(fast.value):near(0.75, 0.04)                       -- 1 - (1 - t)^2
end)

test("back returns to the start, and times repeats", function()
  local thing, peaks = { value = 0 }, 0
  tween(thing, 0.2, { value = 1 }, { back = true, times = 3 })
  local rising = true
  for _ = 1, 90 do
    local last = thing.value
    wait(0)
    if rising and thing.value < last then peaks = peaks + 1 end
    rising = thing.value >= last and (thing.value > last or rising)
    if thing.value < last then rising = false end
  end
  expect(peaks):equals(3)
  expect(thing.value):near(0, 1e-9)
end)

test("a new tween of a field takes over from the old one", function()
  local thing = { value = 0, other = 0 }
  tween(thing, 1, { value = 10, other = 10 })
  wait(0.5)
  tween(thing, 0.5, { value = 0 })
  wait(1)
  expect(thing.value):equals(0)
  expect(thing.other):equals(10)
end)

test("colors, rotations and behaviours' fields can be tweened", function()
  local node = scene.add { color = "black", behaviours = { witness = {} } }
  wait(0.1)
  tween(node, 0.2, { color = "white", rotation = quat.axis_angle(vec3.up, 1) })
  tween(node.behaviours.witness, 0.2, { speed = 9 })
  wait(0.4)
  expect(node.color == color "white"):equals(true)
  expect(node.forward):near(quat.axis_angle(vec3.up, 1) * vec3.forward, 1e-9)
  expect(node.behaviours.witness.speed):equals(9)
end)

test("a task belongs to the behaviour whose handler started it: it is held and ends with it", function()
  local record = require "record"
  local node = scene.add { behaviours = { witness = { label = "it" } } }
  wait(0)
  record.lines = {}
  node:send("beat", 0.1)
  wait(0.55)
  expect(#record.lines):equals(5)
  node.behaviours.witness.enabled = false
  wait(0.5)
  expect(#record.lines):equals(5)
  node.behaviours.witness.enabled = true
  wait(0.2)
  expect(#record.lines):equals(7)
  node:destroy()
  wait(0.5)
  expect(record.lines[#record.lines]):equals("it destroyed")
  expect(#record.lines):equals(8)
end)

test("a tween ends in silence with what it moves: a node, a component, a joint, a part of one, a behaviour", function()
  local box = scene.add { name = "box", position = vec3(0, 5, 0), mesh = "box", light = "point", body = {}, behaviours = { witness = {} } }
  local hinge = joint.hinge { a = box, axis = vec3.up, motor = { target_degrees = 10, torque = 1 } }
  wait(0.1)
  local tweens = { tween(box, 9, { scale = vec3(2, 2, 2) }), tween(box.light, 9, { brightness = 3 }), tween(box.body, 9, { mass = 3 }),
    tween(hinge.motor, 9, { torque = 5 }), tween(box.behaviours.witness, 9, { speed = 8 }) }
  wait(0.1)
  for _, running in ipairs(tweens) do expect(running.is_done):equals(false) end
  box:destroy()
  wait(0.1)
  for _, ended in ipairs(tweens) do expect(ended.is_done):equals(true) end
end)
