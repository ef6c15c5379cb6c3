-- expect: tween: not at the top level of a file, which runs again at every save; put it in start()
local ball = scene.add { mesh = "sphere" }
tween(ball, 1, { position = vec3.up })
