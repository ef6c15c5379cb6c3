-- expect: body:apply_impulse: frame only draws
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function frame(dt) ball.body:apply_impulse(vec3.up) end
