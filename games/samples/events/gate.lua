-- Watch: the ball turns green while it is inside the gate, and leaves a red mark wherever it hits the floor.
-- Both partners of a contact are told; here the gate hears of the ball, and the ball of the floor.
scene.add { name = "camera", position = vec3(0, 3, 8), rotation_degrees = vec3(-10, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(8, 0.2, 6) }, body = { type = "static", restitution = 0.8 } }
local ball = scene.add { name = "ball", position = vec3(-1.5, 4, 0), color = "orange",
  mesh = { shape = "sphere", radius = 0.3 }, body = { mass = 0.5, velocity = vec3(0.4, 0, 0) } }

-- A trigger lets bodies through and tells who came and who went.
local gate = scene.add { name = "gate", position = vec3(0, 1.6, 0), mesh = { shape = "box", size = vec3(4, 0.6, 2) },
  material = { color = "deepskyblue", opacity = 0.3 }, body = { type = "static", trigger = true } }

function gate.on_trigger_enter(hit) hit.node.color = "limegreen" end
function gate.on_trigger_exit(hit) hit.node.color = "orange" end

function ball.on_collision_enter(hit)
  print(("%s hit the %s at %.2f m/s, with %.2f N s"):format(ball.name, hit.node.name, hit.speed, hit.impulse))
  local mark = scene.add { position = hit.point, color = "red",
    mesh = { shape = "sphere", radius = 0.05 + hit.impulse * 0.01 } }
  task.after(3, mark.destroy, mark)                          -- nodes may be made and ended in any handler
end
