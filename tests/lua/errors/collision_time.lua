-- expect: hit.time: a collision does not tell a moment within its tick, a trigger does; use time.now
scene.add { mesh = "box", body = "static" }
local ball = scene.add { position = vec3(0, 1.2, 0), mesh = "sphere", body = { mass = 1 } }
function ball.on_collision_enter(hit) print(hit.time) end
