-- expect: joint.universal: axis_b must not be parallel to axis (got 0, 1, 0 and 0, 2, 0); give a direction across it, or leave it out
local shaft = scene.add { mesh = "box", body = { mass = 1 } }
joint.universal { a = shaft, axis = vec3(0, 2, 0), axis_b = vec3.up }
