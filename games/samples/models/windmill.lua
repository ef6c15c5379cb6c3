-- Watch: a clip of the model turns the blades, and a body that bears the name of the model's node turns with them, so
-- that the blades throw what comes near. Space stops the wind and lets it blow again.
scene.add { name = "camera", position = vec3(5, 3.5, 9), rotation_degrees = vec3(-5, 27, 0), camera = {} }
scene.add { name = "meadow", position = vec3(0, -0.1, 0), color = "olivedrab", body = "static",
  mesh = { shape = "box", size = vec3(30, 0.2, 30) } }

local wind = { file = "windmill.glb", clip = "turn", speed = 2 }
local mill = scene.add { name = "mill", mesh = { file = "windmill.glb" }, animation = wind,
  body = { type = "static", colliders = { shape = "cylinder", radius = 1.2, height = 5, offset = vec3(0, 2.5, 0) } },
  children = {
    { name = "blades", body = { type = "kinematic", colliders = {
      { shape = "box", size = vec3(0.8, 5.6, 0.2) },
      { shape = "box", size = vec3(5.6, 0.8, 0.2) },
    } } },
  } }

local function send_ball()
  local side = random.between(-2.5, 2.5)
  local ball = scene.add { position = vec3(side, 8, 1.25), color = "orange", mesh = { shape = "sphere", radius = 0.2 }, body = { mass = 1 } }
  task.after(6, function() ball:destroy() end)
end

function start() task.every(0.7, send_ball) end
function on_press(name)
  if name == "space" then mill.animation.playing = not mill.animation.playing end
end
