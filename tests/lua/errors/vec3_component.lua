-- expect: vec3 values do not change; write node.position = node.position:with_x(3)
local ball = scene.add { name = "ball" }
function start() ball.position.x = 3 end
