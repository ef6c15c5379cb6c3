-- expect: joint.cylindrical: slide: min must not be above max (got 1 and -1 m); leave both out for no limit
local ring = scene.add { mesh = "box", body = { mass = 1 } }
joint.cylindrical { a = ring, axis = vec3.up, slide = { min = 1, max = -1 } }
