-- expect: the node has no body: add one with node.body = { mass = 1 }
local ball = scene.add { name = "ball", mesh = "sphere" }
function start() ball.body.mass = 2 end
