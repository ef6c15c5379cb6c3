-- expect: node:turn: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up
local door = scene.add { name = "door" }
function update(dt) door:turn(vec3.zero, dt) end
