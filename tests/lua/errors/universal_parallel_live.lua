-- expect: joint.universal: axis_b must not be parallel to axis (got 1, 0, 0 and 1, 0, 0); give a direction across it, or leave it out
local shaft = scene.add { mesh = "box", body = { mass = 1 } }
local cross = joint.universal { a = shaft, axis = vec3.right }
function start() cross.axis_b = vec3.right end
