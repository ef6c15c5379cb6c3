-- expect: finite
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function start() ball.body:apply_impulse(vec3.up / 0) end
