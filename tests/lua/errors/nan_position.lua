-- expect: a finite number expected
local ball = scene.add { name = "ball" }
function start() ball.position = vec3(0 / 0, 0, 0) end
