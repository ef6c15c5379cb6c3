-- Listen: the lamp with the motor circles around you, loud in front and soft far off, left and right as you see it; space rings
-- the bell where the blue ball stands. A sound with a place is heard from the camera.
local way = 0

scene.add { name = "camera", position = vec3(0, 1.6, 0), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray", mesh = { shape = "box", size = vec3(40, 0.2, 40) } }
local motor = scene.add { name = "motor", color = "tomato", mesh = { shape = "box", size = vec3(0.8, 0.8, 0.8) },
  sound = { file = "motor.wav", loop = true, playing = true, range = 24 } }     -- it moves with its node
local ball = scene.add { name = "ball", position = vec3(3, 0.5, -6), color = "royalblue", mesh = "sphere" }

function update(dt)
  way = way + 0.7 * dt
  motor.position = vec3(5 * math.sin(way), 0.6, -4 - 7 * math.cos(way))
  motor.sound.pitch = 1 + 0.3 * math.sin(3 * way)                              -- fields can be written while it plays
end

function on_press(name)
  if name == "space" then sound.play("bell.wav", { at = ball }) end
  if name == "m" then motor.sound.playing = not motor.sound.playing end
end

function draw_ui()
  ui.text("space: the bell   m: the motor", { at = "bottom", size = 24 })
end
