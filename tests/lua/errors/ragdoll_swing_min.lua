-- expect: joint.ragdoll: swing_a has no field 'min_degrees'; did you mean 'max_degrees'?
local arm = scene.add { mesh = "box", body = { mass = 1 } }
joint.ragdoll { a = arm, swing_a = { min_degrees = -20, max_degrees = 40 } }
