-- Bodies, their events and queries.
local record = require "record"

test("free fall is the parabola, tick by tick", function()
  local ball = scene.add { name = "ball", position = vec3(0, 50, 0), mesh = "sphere", body = { mass = 2, velocity = vec3(3, 4, -1) } }
  for i = 1, 60 do
    wait(0)
    local t = i / 60
    expect(ball.position):near(vec3(0, 50, 0) + vec3(3, 4, -1) * t + physics.gravity * (t * t / 2), 1e-6)
  end
end)

test("an impulse changes the momentum by itself, a force by force times time", function()
  local kicked = scene.add { position = vec3(0, 50, 0), mesh = "sphere", body = { mass = 2, gravity_factor = 0 } }
  local pushed = scene.add { position = vec3(5, 50, 0), mesh = "sphere", body = { mass = 2, gravity_factor = 0 } }
  kicked.body:apply_impulse(vec3(6, 0, 0))
  expect(kicked.body.velocity):near(vec3(3, 0, 0), 1e-9)
  for _ = 1, 30 do
    pushed.body:apply_force(vec3(4, 0, 0))
    wait(0)
  end
  expect(pushed.body.velocity):near(vec3(4 * 0.5 / 2, 0, 0), 1e-6)
  expect(kicked.body.momentum):near(vec3(6, 0, 0), 1e-6)
  expect(kicked.body.kinetic_energy):near(9, 1e-6)          -- m v^2 / 2
end)

test("both partners of a collision are told, the older first, each from its own side", function()
  local low = scene.add { name = "low", position = vec3(0, 0.5, 0), mesh = "box", body = { mass = 1 }, behaviours = { witness = { label = "low" } } }
  local high = scene.add { name = "high", position = vec3(0, 3, 0), mesh = "box", body = { mass = 1 }, behaviours = { witness = { label = "high" } } }
  wait(0.3)
  record.lines = {}
  local hits = {}
  function low.on_collision_enter(hit) hits.low = hit end
  function high.on_collision_enter(hit) hits.high = hit end
  wait(1)
  expect(record.lines[1]):equals("low meets high")
  expect(record.lines[2]):equals("high meets low")
  expect(hits.low.normal):near(vec3.down, 1e-3)             -- towards me
  expect(hits.high.normal):near(vec3.up, 1e-3)
  expect(hits.high.speed):near(math.sqrt(2 * 9.81 * 1.5), 0.2)
  expect(hits.low.impulse):near(hits.high.impulse, 1e-9)
  expect(hits.high.point.y):near(1, 0.02)
end)

test("a contact that goes on ends once, also by destroying the partner", function()
  local box = scene.add { name = "box", position = vec3(0, 0.5, 0), mesh = "box", body = { mass = 1 } }
  local enters, exits = 0, 0
  function box.on_collision_enter(hit) enters = enters + 1 end
  function box.on_collision_exit(hit)
    exits = exits + 1
    record.left = hit.node.name
  end
  wait(2)
  expect(enters):equals(1)
  expect(exits):equals(0)
  scene.get("floor"):destroy()
  wait(0.1)
  expect(exits):equals(1)
  expect(record.left):equals("floor")
end)

test("a trigger tells who comes and who goes, and lets it through", function()
  local zone = scene.add { name = "zone", position = vec3(0, 5, 0), body = { type = "static", trigger = true, colliders = { shape = "box", size = vec3(2, 1, 2) } } }
  local ball = scene.add { name = "ball", position = vec3(0, 8, 0), mesh = { shape = "sphere", radius = 0.2 }, body = { mass = 1 } }
  local came, went, visits
  function zone.on_trigger_enter(hit) came = { hit.node.name, time.now } end
  function zone.on_trigger_exit(hit) went = { hit.node.name, time.now } end
  function ball.on_trigger_enter(hit) visits = hit.node.name end
  local begun = time.now
  wait(1.2)
  expect(came[1]):equals("ball")
  expect(visits):equals("zone")
  -- Falls 2.3 m until it touches the upper face, 3.7 m until it leaves the lower one.
  expect(came[2] - begun):near(math.sqrt(2 * 2.3 / 9.81), 0.035)
  expect(went[2] - begun):near(math.sqrt(2 * 3.7 / 9.81), 0.035)
end)

test("a trigger tells when within the tick it was crossed, on the clock of time.now", function()
  local zone = scene.add { name = "zone", position = vec3(0, 5, 0), body = { type = "static", trigger = true, colliders = { shape = "box", size = vec3(2, 1, 2) } } }
  local ball = scene.add { name = "ball", position = vec3(0, 8, 0), mesh = { shape = "sphere", radius = 0.2 }, body = { mass = 1 } }
  local came, stayed, went, now, seen
  function zone.on_trigger_enter(hit) came, now = hit.time, time.now end
  function zone.on_trigger_stay(hit) stayed = stayed or hit.time == time.now end
  function zone.on_trigger_exit(hit) went = hit.time end
  function ball.on_trigger_enter(hit) seen = hit.time end
  wait(0)
  local begun = time.now - time.tick_seconds   -- the ball joined the world in the tick before
  wait(1.2)
  expect(came - begun):near(math.sqrt(2 * 2.3 / 9.81), 1e-6)
  expect(went - begun):near(math.sqrt(2 * 3.7 / 9.81), 1e-6)
  expect(seen):equals(came)
  expect(came <= now and came > now - time.tick_seconds):equals(true)
  expect(stayed):equals(true)
end)

test("what leaves a trigger by its end leaves it now", function()
  local zone = scene.add { name = "zone", position = vec3(0, 5, 0), body = { type = "static", trigger = true, colliders = { shape = "box", size = vec3(2, 1, 2) } } }
  local ball = scene.add { name = "ball", position = vec3(0, 5, 0), mesh = "sphere", body = { gravity_factor = 0 } }
  local went, now
  function zone.on_trigger_exit(hit) went, now = hit.time, time.now end
  wait(0.1)
  ball:destroy()
  wait(0.1)
  expect(went):equals(now)
end)

test("bodies may be made, moved and ended inside a handler", function()
  local ball = scene.add { name = "ball", position = vec3(0, 2, 0), mesh = "sphere", body = { mass = 1 } }
  local other
  function ball.on_collision_enter(hit)
    other = scene.add { name = "other", position = vec3(3, 2, 0), mesh = "box", body = { mass = 1 } }
    ball:destroy()
  end
  wait(1.5)
  expect(ball.is_alive):equals(false)
  expect(other.position.y):near(0.5, 0.02)
end)

test("a body at rest falls asleep and says so; a push wakes it", function()
  local box = scene.add { name = "box", position = vec3(0, 0.5, 0), mesh = "box", body = { mass = 1 } }
  local told = {}
  function box.on_sleep() table.insert(told, "sleep") end
  function box.on_wake() table.insert(told, "wake") end
  wait(3)
  expect(box.body.is_asleep):equals(true)
  box.body:apply_impulse(vec3(0, 2, 0))
  wait(0.1)
  expect(table.concat(told, " ")):equals("sleep wake")
end)

test("a ray finds the nearest body, its point, normal and distance", function()
  scene.add { name = "near", position = vec3(0, 5, -3), mesh = "box", body = "static" }
  scene.add { name = "far", position = vec3(0, 5, -8), mesh = "box", body = "static" }
  wait(0)
  local hit = physics.raycast(vec3(0, 5, 0), vec3(0, 0, -2), 20)
  expect(hit.node.name):equals("near")
  expect(hit.distance):near(2.5, 1e-6)
  expect(hit.point):near(vec3(0, 5, -2.5), 1e-6)
  expect(hit.normal):near(vec3.back, 1e-6)
  expect(#physics.raycast_all(vec3(0, 5, 0), vec3.forward, 20)):equals(2)
  expect(physics.raycast(vec3(0, 5, 0), vec3.forward, 2)):equals(nil)
  expect(physics.raycast(vec3(0, 5, 0), vec3.forward, 20, { ignore = scene.get("near") }).node.name):equals("far")
  expect(physics.raycast_to(vec3(0, 5, 0), vec3(0, 5, -2))):equals(nil)
  expect(physics.raycast_any(vec3(0, 9, 0), vec3.forward, 20)):equals(false)
end)

test("filters choose by tag, node and question", function()
  scene.add { name = "red one", tags = "red", position = vec3(0, 5, -3), mesh = "box", body = "static" }
  scene.add { name = "blue one", tags = "blue", position = vec3(0, 5, -8), mesh = "box", body = "static" }
  wait(0)
  local function first(filter) return physics.raycast(vec3(0, 5, 0), vec3.forward, 20, filter).node.name end
  expect(first { tags = "blue" }):equals("blue one")
  expect(first { only = scene.get("blue one") }):equals("blue one")
  expect(first { accept = function(node) return node.name:find("blue") ~= nil end }):equals("blue one")
  expect(first(physics.filter { tags = { "red", "blue" } })):equals("red one")
end)

test("a moving sphere meets a wall a radius earlier than a ray", function()
  scene.add { name = "wall", position = vec3(0, 5, -5), mesh = "box", body = "static" }
  wait(0)
  local hit = physics.cast({ shape = "sphere", radius = 0.5 }, vec3(0, 5, 0), vec3.forward, 20)
  expect(hit.distance):near(4, 0.02)
  local found = physics.overlap({ shape = "sphere", radius = 1 }, vec3(0, 5, -4))
  expect(#found):equals(1)
  expect(found[1].name):equals("wall")
end)

test("a hinge keeps its limits, and breaks by force, once, and tells both", function()
  local arm = scene.add { name = "arm", position = vec3(0.5, 5, 0), mesh = { shape = "box", size = vec3(1, 0.1, 0.1) }, body = { mass = 1 } }
  local hinge = joint.hinge { name = "hinge", a = arm, anchor = vec3(-0.5, 0, 0), axis = vec3.back, min_degrees = -30, max_degrees = 30 }
  wait(2)
  expect(hinge.angle_degrees):near(-30, 1)
  expect(arm:joint("hinge") == hinge):equals(true)
  local breaks = 0
  function arm.on_joint_break(broken) breaks = breaks + 1 end
  hinge.break_force = 50
  arm.body:apply_impulse(vec3(30, 0, 0))
  wait(0.5)
  expect(hinge.is_broken):equals(true)
  expect(breaks):equals(1)
end)

test("a motor turns at its speed", function()
  local wheel = scene.add { name = "wheel", position = vec3(0, 5, 0), mesh = { shape = "cylinder" }, body = { mass = 1 } }
  local axle = joint.hinge { a = wheel, axis = vec3.up, motor = { speed = 3 } }
  wait(1)
  expect(axle.speed):near(3, 0.01)
  expect(wheel.body.angular_velocity):near(vec3(0, 3, 0), 0.01)
  axle.motor.speed = -1
  wait(1)
  expect(axle.speed):near(-1, 0.01)
end)

test("a kinematic body goes where it is put and carries what stands on it", function()
  local lift = scene.add { name = "lift", position = vec3(0, 1, 0), mesh = { shape = "box", size = vec3(2, 0.2, 2) }, body = "kinematic" }
  local box = scene.add { name = "box", position = vec3(0, 1.6, 0), mesh = "box", body = { mass = 1 } }
  wait(0.5)
  for _ = 1, 60 do
    lift:translate(vec3(1 / 60, 0, 0))
    wait(0)
  end
  wait(0.2)
  expect(lift.position.x):near(1, 1e-6)
  expect(box.position.x):near(1, 0.15)
end)

test("teleport jumps and keeps the velocity", function()
  local ball = scene.add { name = "ball", position = vec3(0, 20, 0), mesh = "sphere", body = { mass = 1, gravity_factor = 0, velocity = vec3(1, 0, 0) } }
  ball:teleport(vec3(5, 20, 0))
  expect(ball.position):equals(vec3(5, 20, 0))
  wait(0.5)
  expect(ball.position):near(vec3(5.5, 20, 0), 1e-6)
end)

test("a NaN or an infinity is refused where it is given", function()
  local ball = scene.add { name = "ball", position = vec3(0, 5, 0), mesh = "sphere", body = { mass = 1 } }
  expect(function() ball.position = vec3(0 / 0, 0, 0) end):raises("finite")
  expect(function() ball.body.velocity = vec3.up * math.huge end):raises("finite")
  expect(function() ball.body:apply_force(vec3.up / 0) end):raises("finite")
  expect(function() ball.body.mass = math.huge end):raises("finite")
  expect(ball.position):near(vec3(0, 5, 0), 0.1)
end)

test("a stay that is asked for in play is told from then on", function()
  local box = scene.add { name = "box", position = vec3(0, 0.5, 0), mesh = "box", body = { can_sleep = false } }
  wait(0.2)
  local stays = 0
  function box.on_collision_stay(hit) stays = stays + 1 end
  wait(0.5)
  expect(stays):above(20)
  box.on_collision_stay = nil
  local before = stays
  wait(0.2)
  expect(stays):equals(before)
end)

test("who stays is told in every tick after the first, until it goes", function()
  local shaft = scene.add { name = "shaft", position = vec3(0, 50, 0), mesh = { shape = "box", size = vec3(2, 2, 2) },
    body = { type = "static", trigger = true } }
  local ball = scene.add { name = "ball", position = vec3(0, 50, 0), mesh = "sphere", body = { gravity_factor = 0, can_sleep = false } }
  local enters, stays, exits = 0, 0, 0
  function shaft.on_trigger_enter() enters = enters + 1 end
  function shaft.on_trigger_stay(hit)
    stays = stays + 1
    expect(hit.node):equals(ball)
  end
  function shaft.on_trigger_exit() exits = exits + 1 end
  wait(1)
  expect(enters):equals(1)
  expect(stays):near(58, 2)                                 -- 60 ticks: one to enter, one to hear of the handlers
  ball:teleport(vec3(0, 60, 0))
  wait(0.1)
  local before = stays
  wait(0.2)
  expect(exits):equals(1)
  expect(stays):equals(before)
end)

test("the impulses of a contact that goes on carry the weight", function()
  local box = scene.add { name = "box", position = vec3(0, 0.5, 0), mesh = "box", body = { mass = 3, can_sleep = false } }
  local impulse = 0
  function box.on_collision_stay(hit)
    impulse = impulse + hit.impulse
  end
  wait(0.5)
  local before, begun = impulse, time.tick
  wait(1)
  expect((impulse - before) / ((time.tick - begun) * time.tick_seconds)):near(3 * 9.81, 0.6)   -- the mean force
end)
