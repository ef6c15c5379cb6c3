-- expect: tween: field 'position': vec3 expected, got 3
local ball = scene.add { mesh = "sphere" }
function start() tween(ball, 1, { position = 3 }) end
