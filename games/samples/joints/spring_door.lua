-- Watch: balls push the door open and its spring shuts it again. Change `damping`: 0 swings for ever, 1 shuts
-- without swinging over. Each press of space sends the next ball.
local damping = 0.3

scene.add { name = "camera", position = vec3(2.5, 2.6, 4.5), rotation_degrees = vec3(-20, 30, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(8, 0.2, 8) }, body = "static" }
local frame = scene.add { name = "frame", position = vec3(-0.65, 1, 0), color = "saddlebrown",
  mesh = { shape = "box", size = vec3(0.1, 2, 0.1) }, body = "static" }
local door = scene.add { name = "door", position = vec3(0, 1, 0), color = "peru",
  mesh = { shape = "box", size = vec3(1.2, 1.9, 0.05) }, body = { mass = 10 } }

local hinge = joint.hinge { name = "hinge", a = door, b = frame, anchor = vec3(-0.6, 0, 0), axis = vec3.up,
  min_degrees = -110, max_degrees = 110, spring = { frequency = 0.6, damping = damping } }

local function send_ball()
  scene.add { position = vec3(0.3, 0.8, 2.5), color = "orange", mesh = { shape = "sphere", radius = 0.2 },
    body = { mass = 2, velocity = vec3(0, 1.5, -7) } }
end

function start() task.after(0.5, send_ball) end
function on_press(name)
  if name == "space" then send_ball() end
end
function update(dt) log.watch("door, degrees", hinge.angle_degrees) end
