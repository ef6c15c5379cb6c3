-- expect: tween: field 'name' holds "ball"; only numbers, vec3, quat and color can be tweened
local ball = scene.add { name = "ball" }
function start() tween(ball, 1, { name = "cube" }) end
