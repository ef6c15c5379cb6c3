-- Watch: what each joint leaves free. The fixed arm does not move at all, the hinge swings in one plane, the slider
-- goes up and down by its motor, the ball joint swings any way. F3 shows anchors and axes.
scene.add { name = "camera", position = vec3(0, 2.2, 9), rotation_degrees = vec3(-4, 0, 0), camera = {} }

local function post(name, x)
  return scene.add { name = name .. " post", position = vec3(x, 3, 0), color = "dimgray",
    mesh = { shape = "box", size = vec3(0.5, 0.5, 0.5) }, body = "static" }
end
local function arm(name, x, color)
  return scene.add { name = name, position = vec3(x, 1.9, 0), color = color,
    mesh = { shape = "box", size = vec3(0.25, 1.6, 0.25) }, body = { mass = 1 } }
end
local top = vec3(0, 0.8, 0)                      -- an arm's upper end, in the arm's own coordinates

local hinged, hung = arm("hinge", -1.2, "gold"), arm("ball", 3.6, "skyblue")
joint.fixed { a = arm("fixed", -3.6, "tomato"), b = post("fixed", -3.6), anchor = top }
joint.hinge { a = hinged, b = post("hinge", -1.2), anchor = top, axis = vec3.back, min_degrees = -60, max_degrees = 60 }
joint.ball { a = hung, b = post("ball", 3.6), anchor = top }
local lift = joint.slider { a = arm("slider", 1.2, "yellowgreen"), b = post("slider", 1.2), axis = vec3.up,
  min = -1, max = 0.4, motor = { speed = 0.5, force = 40 } }

function start()
  hinged.body:apply_angular_impulse(vec3(0, 0, 2))
  hung.body:apply_impulse(vec3(1, 0, 1.5), hung:to_world(vec3(0, -0.8, 0)))
end

function update(dt)
  if lift.position > 0.35 then lift.motor.speed = -0.5 end
  if lift.position < -0.95 then lift.motor.speed = 0.5 end
  log.watch("slider, m", lift.position)
end
