-- expect: node 'ball' has no 'positoin'; did you mean 'position'?
local ball = scene.add { name = "ball" }
function start() print(ball.positoin) end
