-- expect: body.mass
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function start() ball.body.mass = 0 / 0 end
