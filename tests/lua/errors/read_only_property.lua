-- expect: node.path: can be read but not written
local ball = scene.add { name = "ball" }
function start() ball.path = "a/b" end
