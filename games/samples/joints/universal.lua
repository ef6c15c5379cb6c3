-- Watch: both shafts make a turn in the same time, but the red one, behind the universal joint, hurries and lags twice in
-- each. Change `bend`: at 45 degrees it is 0.7 to 1.4 times as fast as the gold one, at 0 as fast.
local bend, speed = math.rad(45), 3

scene.add { name = "camera", position = vec3(0, 1.7, 3.8), rotation_degrees = vec3(-6, 0, 0), camera = {} }

-- A shaft along its x, with a flag that shows how it turns.
local function shaft(name, center, rotation, color)
  return scene.add { name = name, position = center, rotation = rotation, color = color,
    mesh = { shape = "box", size = vec3(1.6, 0.12, 0.12) }, body = { mass = 1, can_sleep = false },
    children = { { name = "flag", position = vec3(0, 0.3, 0), color = color, mesh = { shape = "box", size = vec3(0.4, 0.5, 0.04) } } } }
end
local bent = quat.axis_angle(vec3.back, bend)
local gold = shaft("gold", vec3(-0.8, 1, 0), quat.identity, "gold")
local red = shaft("red", vec3(0, 1, 0) + bent * vec3(0.8, 0, 0), bent, "tomato")

-- Each shaft in its bearing; the gold one is driven.
joint.hinge { a = gold, axis = vec3.right, motor = { speed = speed } }
joint.hinge { a = red, axis = vec3.right }

-- The cross between them: one arm across the gold shaft, one across the red one, and the arms across each other.
local cross = joint.universal { a = gold, b = red, anchor = vec3(0.8, 0, 0), axis = vec3.back, axis_b = bent * vec3.up }

function update(dt)
  log.watch("gold, rad/s", gold.body.angular_velocity:length())
  log.watch("red, rad/s", red.body.angular_velocity:length())
  log.watch("red arm, degrees", cross.turn_b.angle_degrees)
end
