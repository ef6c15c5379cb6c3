-- expect: body has no 'restituton'; did you mean 'restitution'?
local ball = scene.add { mesh = "sphere", body = { mass = 1 } }
function start() ball.body.restituton = 0.5 end
