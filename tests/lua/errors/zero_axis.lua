-- expect: joint.hinge: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up
local door = scene.add { name = "door", mesh = "box", body = { mass = 1 } }
joint.hinge { a = door, axis = vec3.zero }
