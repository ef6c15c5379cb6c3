-- expect: joint.ball: anchor and world_anchor are given both; give one of them
local box = scene.add { mesh = "box", body = { mass = 1 } }
joint.ball { a = box, anchor = vec3.up, world_anchor = vec3.up }
