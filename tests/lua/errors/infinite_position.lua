-- expect: finite
local ball = scene.add { name = "ball" }
function start() ball.position = vec3.up * (1 / 0) end
