-- expect: joint.position: belongs to a slider, and this is a hinge
local door = scene.add { mesh = "box", body = { mass = 1 } }
local hinge = joint.hinge { a = door, axis = vec3.up }
function start() print(hinge.position) end
