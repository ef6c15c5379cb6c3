-- expect: node.scale: each number must be above 0 (got vec3(1, 0, 1))
local ball = scene.add { mesh = "sphere" }
function start() ball.scale = vec3(1, 0, 1) end
