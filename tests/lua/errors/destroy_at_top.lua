-- expect: node:destroy: not at the top level of a file, which runs again at every save; put it in start()
local ball = scene.add { name = "ball" }
ball:destroy()
