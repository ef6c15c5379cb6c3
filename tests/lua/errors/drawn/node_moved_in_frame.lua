-- expect: node:translate: frame only draws; change things in update or late_update
local ball = scene.add { name = "ball", mesh = "sphere" }
function frame(dt) ball:translate(vec3.up, dt) end
