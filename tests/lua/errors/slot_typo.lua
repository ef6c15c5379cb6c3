-- expect: no event 'on_colision_enter'; did you mean 'on_collision_enter'?
local ball = scene.add { mesh = "sphere", body = { mass = 1 } }
function ball.on_colision_enter(hit) end
