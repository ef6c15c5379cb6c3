-- What scripts set of the physical world, and what it tells.

test("physics: a profile is a number of substeps, and a number of substeps comes before it", function()
  expect(physics.profile):equals("balanced")
  expect(physics.substeps):equals(nil)
  local floor = scene.add { mesh = { shape = "box", size = vec3(10, 1, 10) }, body = "static" }
  local stone = scene.add { position = vec3(0, 1, 0), mesh = "box", body = { can_sleep = false } }
  for profile, substeps in pairs { fast = 2, balanced = 4, exact = 16 } do
    physics.profile = profile
    wait(0.1)
    expect(physics.stats().substeps):equals(substeps)
  end
  physics.substeps = 7
  wait(0.1)
  expect(physics.stats().substeps):equals(7)
  expect(physics.stats().islands):equals(1)
  physics.substeps = nil
  physics.profile = "balanced"
  wait(0.1)
  expect(physics.stats().substeps):equals(4)
  stone:destroy()
  floor:destroy()
end)

test("physics: what is no profile or no number of substeps is refused with what would do", function()
  expect(function() physics.profile = "exat" end):raises("exact")
  expect(function() physics.substeps = 0 end):raises("1 to 64")
  expect(physics.profile):equals("balanced")
end)

test("physics: what flies alone takes one substep, which is exact", function()
  local stone = scene.add { position = vec3(0, 100, 0), mesh = "box", body = {} }
  wait(0.1)
  expect(physics.stats().substeps):equals(1)
  stone:destroy()
end)

test("physics: rolling friction can be changed while it rolls", function()
  local floor = scene.add { mesh = { shape = "box", size = vec3(40, 1, 10) }, body = "static" }
  local ball = scene.add { position = vec3(-10, 1, 0), mesh = { shape = "sphere", radius = 0.5 },
    body = { velocity = vec3(3, 0, 0), angular_velocity = vec3(0, 0, -6), friction = 1 } }
  wait(1)
  expect(ball.body.velocity.x):near(3, 1e-3)
  ball.body.rolling_friction = 0.1
  local began = time.now
  wait(1)
  expect(ball.body.velocity.x):near(3 - 0.1 * 9.81 / 1.4 * (time.now - began), 0.02)  -- a solid ball: 5/7 of c g
  ball:destroy()
  floor:destroy()
end)

test("physics: a body tells its centre of mass and its moments, and takes others", function()
  local hammer = scene.add { position = vec3(0, 50, 0), body = { mass = 3, colliders = {
    { shape = "box", size = vec3(1, 1, 1) }, { shape = "box", size = vec3(1, 1, 1), offset = vec3(2, 0, 0) } } } }
  wait(0.05)
  expect(hammer.body.center_of_mass):near(vec3(1, 0, 0), 1e-12)
  expect(hammer.body.inertia):near(vec3(0.5, 0.5 + 3, 0.5 + 3), 1e-9)   -- two cubes, m / 6 each, a metre off
  hammer.body.center_of_mass = vec3.zero
  expect(hammer.body.center_of_mass):equals(vec3.zero)
  hammer.body.inertia = vec3(2, 3, 4)
  expect(hammer.body.inertia):equals(vec3(2, 3, 4))
  expect(function() hammer.body.inertia = vec3(1, 1, 5) end):raises("above the sum of the other two (got 1, 1, 5)")
  expect(function() hammer.body.inertia = vec3(0, 1, 1) end):raises("above 0 (got 0, 1, 1)")
  expect(hammer.body.inertia):equals(vec3(2, 3, 4))
  hammer.body.inertia = nil
  hammer.body.center_of_mass = nil
  expect(hammer.body.inertia):near(vec3(0.5, 3.5, 3.5), 1e-9)
  hammer:destroy()
end)
