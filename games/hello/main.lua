-- A ball bounces, and space kicks it. Change a number while it runs, save, and watch: nothing starts over.
scene.add { name = "floor", color = "seagreen", mesh = { shape = "box", size = vec3(10, 0.2, 10) }, body = "static" }

local ball = scene.add { name = "ball", position = vec3(0, 3, 0), color = "orange",
  mesh = { shape = "sphere", radius = 0.3 }, body = { mass = 0.6, restitution = 0.8 } }

function on_press(name)
  if name == "space" then ball.body:apply_impulse(vec3(0, 3, 0)) end
end
