-- expect: node 'ball' has no 'velocity'; it belongs to the body: node.body.velocity
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function start() ball.velocity = vec3.up end
