-- expect: joint.hinge: min must not be above max (got 1 and -1 rad); leave both out for no limit
local door = scene.add { name = "door", mesh = "box", body = { mass = 1 } }
joint.hinge { a = door, axis = vec3.up, min = 1, max = -1 }
