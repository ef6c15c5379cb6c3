-- expect: was it called with a dot? Write body:apply_impulse(...)
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function start() ball.body.apply_impulse(vec3.up) end
