-- expect: body:apply_impulse: not at the top level of a file, which runs again at every save; put it in start()
local ball = scene.add { mesh = "sphere", body = { mass = 1 } }
ball.body:apply_impulse(vec3.up)
