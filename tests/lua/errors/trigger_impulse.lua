-- expect: hit.impulse: a trigger pushes nobody and has no impulse
local zone = scene.add { mesh = "box", body = { type = "static", trigger = true } }
scene.add { position = vec3(0, 1.2, 0), mesh = "sphere", body = { mass = 1 } }
function zone.on_trigger_enter(hit) print(hit.impulse) end
