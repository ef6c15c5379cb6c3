-- Watch: what each joint leaves free. The fixed arm does not move at all, the hinge swings in one plane, the slider goes
-- up and down by its motor, the cylindrical one also turns, the ball swings any way, the universal joint does not twist,
-- and the ragdoll's arm stays within its cone. F3 shows anchors, axes and limits.
scene.add { name = "camera", position = vec3(0, 2.2, 11), rotation_degrees = vec3(-3, 0, 0), camera = {} }

local function post(name, x)
  return scene.add { name = name .. " post", position = vec3(x, 3, 0), color = "dimgray",
    mesh = { shape = "box", size = vec3(0.5, 0.5, 0.5) }, body = "static" }
end
local function arm(name, x, color)
  return scene.add { name = name, position = vec3(x, 1.9, 0), color = color,
    mesh = { shape = "box", size = vec3(0.25, 1.6, 0.25) }, body = { mass = 1 } }
end
local top = vec3(0, 0.8, 0)                      -- an arm's upper end, in the arm's own coordinates

local hinged, turning, ball = arm("hinge", -4, "gold"), arm("cylindrical", 0, "turquoise"), arm("ball", 2, "skyblue")
local crossed, bone = arm("universal", 4, "orchid"), arm("ragdoll", 6, "sandybrown")
joint.fixed { a = arm("fixed", -6, "tomato"), b = post("fixed", -6), anchor = top }
joint.hinge { a = hinged, b = post("hinge", -4), anchor = top, axis = vec3.back, min_degrees = -60, max_degrees = 60 }
local motor = { speed = 0.5, force = 40 }
local lift = joint.slider { a = arm("slider", -2, "yellowgreen"), b = post("slider", -2), axis = vec3.up, min = -1, max = 0.4,
  motor = motor }
local drill = joint.cylindrical { a = turning, b = post("cylindrical", 0), axis = vec3.up,
  slide = { min = -1, max = 0.4, motor = motor }, turn = { motor = { speed = 3 } } }
joint.ball { a = ball, b = post("ball", 2), anchor = top }
joint.universal { a = crossed, b = post("universal", 4), anchor = top, axis = vec3.back, axis_b = vec3.right }
joint.ragdoll { a = bone, b = post("ragdoll", 6), anchor = top, axis = vec3.down, swing_axis = vec3.back,
  swing_a = { max_degrees = 25 }, swing_b = { max_degrees = 50 }, twist = { min_degrees = -20, max_degrees = 20 } }

function start()
  hinged.body:apply_angular_impulse(vec3(0, 0, 2))
  for _, hung in ipairs { ball, crossed, bone } do
    hung.body:apply_impulse(vec3(1, 0, 1.5), hung:to_world(vec3(0.1, -0.8, 0)))
  end
end

function update(dt)
  if lift.position > 0.35 then lift.motor.speed, drill.slide.motor.speed = -0.5, -0.5 end
  if lift.position < -0.95 then lift.motor.speed, drill.slide.motor.speed = 0.5, 0.5 end
  log.watch("slider, m", lift.position)
  log.watch("cylindrical, degrees", drill.turn.angle_degrees)
end
