-- Watch: two flaps on hinges carry balls and let them fall every three seconds. A motor with a target turns a hinge to an
-- angle and holds it there, with no more than its torque; the limits stop it. Space opens the flaps at once.
scene.add { name = "camera", position = vec3(0, 2.4, 6.5), rotation_degrees = vec3(-12, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "#34495e",
  mesh = { shape = "box", size = vec3(14, 0.2, 6) }, body = "static" }

-- A wall on each side with a flap at its foot. The flap hinges on its outer edge.
local hinges = {}
for _, side in ipairs { -1, 1 } do
  local wall = scene.add { name = "wall", position = vec3(side * 1.35, 2.5, 0), color = "peru",
    mesh = { shape = "box", size = vec3(0.1, 1.4, 1.4) }, body = "static" }
  local flap = scene.add { name = "flap", position = vec3(side * 0.65, 1.8, 0), color = "gold",
    mesh = { shape = "box", size = vec3(1.28, 0.08, 1.4) }, body = { mass = 4 } }
  table.insert(hinges, joint.hinge { name = "hinge", a = flap, b = wall, anchor = vec3(side * 0.64, 0, 0), axis = vec3.back * side,
    min_degrees = 0, max_degrees = 80, motor = { target_degrees = 0, speed = 4, torque = 300 } })
end
for _, z in ipairs { -0.75, 0.75 } do
  scene.add { position = vec3(0, 2.5, z), material = { color = "lightblue", opacity = 0.25 },
    mesh = { shape = "box", size = vec3(2.8, 1.4, 0.08) }, body = "static" }
end

local function turn_to(degrees)
  for _, hinge in ipairs(hinges) do hinge.motor.target_degrees = degrees end
end
local function open()
  turn_to(80)
  task.after(1.2, turn_to, 0)
end
local function drop()
  local ball = scene.add { position = vec3(random.between(-1, 1), 5, random.between(-0.4, 0.4)),
    color = color.hsv(random.between(0, 1), 0.6, 1),
    mesh = { shape = "sphere", radius = 0.17 }, body = { mass = 1, restitution = 0.2 } }
  task.after(8, ball.destroy, ball)
end

function start()
  task.every(0.15, drop)
  task.every(3, open)
end
function on_press(name)
  if name == "space" then open() end
end
function update(dt) log.watch("left flap, degrees", math.round(hinges[1].angle_degrees)) end
