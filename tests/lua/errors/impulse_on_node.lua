-- expect: node 'ball' has no 'apply_impulse'; it belongs to the body
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function start() ball:apply_impulse(vec3.up) end
