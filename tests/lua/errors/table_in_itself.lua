-- expect: scene.add: a table contains itself
local ball = { name = "ball" }
ball.body = ball
scene.add(ball)
