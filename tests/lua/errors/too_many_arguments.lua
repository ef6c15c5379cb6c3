-- expect: node:has_tag: takes 1 argument
local ball = scene.add { tags = "ball" }
function start() ball:has_tag("ball", "round") end
