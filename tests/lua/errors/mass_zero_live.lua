-- expect: body.mass: must be above 0 (got 0)
local ball = scene.add { mesh = "sphere", body = { mass = 1 } }
function start() ball.body.mass = 0 end
