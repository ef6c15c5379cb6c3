-- expect: node.on_collision_enter: function expected, got 3
local ball = scene.add { mesh = "sphere", body = { mass = 1 } }
ball.on_collision_enter = 3
