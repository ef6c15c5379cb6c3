-- expect: joint.ragdoll: swing_b.max_degrees must be from 0 to 180 (got -30)
local arm = scene.add { mesh = "box", body = { mass = 1 } }
joint.ragdoll { a = arm, swing_b = { max_degrees = -30 } }
