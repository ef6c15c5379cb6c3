-- expect: body.friction: frame only draws; change things in update or late_update
local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }
function frame(dt) ball.body.friction = 1 end
