-- expect: tween: unknown ease 'out_bonce'; did you mean 'out_bounce'?
local ball = scene.add { mesh = "sphere" }
function start() tween(ball, 1, { position = vec3.up }, { ease = "out_bonce" }) end
