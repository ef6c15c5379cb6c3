-- Watch: what the physics knows, drawn over the picture. F3 goes through the views by hand; here a new one comes every
-- three seconds.
scene.add { name = "camera", position = vec3(0, 2, 5.5), rotation_degrees = vec3(-12, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray", mesh = { shape = "box", size = vec3(10, 0.2, 6) }, body = "static" }
local shapes = { { shape = "box" }, { shape = "sphere" }, { shape = "capsule", radius = 0.3, height = 1.2 }, { shape = "cone" },
  { shape = "cylinder" }, { shape = "pyramid" }, { shape = "torus", thickness = 0.3 } }
for i, mesh in ipairs(shapes) do
  scene.add { name = mesh.shape, position = vec3((i - 4) * 1.3, 2 + i % 2, 0), color = "lightsteelblue", mesh = mesh, body = { mass = 1 } }
end
local post = scene.add { name = "post", position = vec3(-3, 0.6, 2), color = "dimgray", mesh = { shape = "box", size = vec3(0.2, 1.2, 0.2) }, body = "static" }
local arm = scene.add { name = "arm", position = vec3(-2.4, 1, 2), color = "gold", mesh = { shape = "box", size = vec3(1.2, 0.15, 0.15) }, body = { mass = 1 } }
joint.hinge { a = arm, b = post, anchor = vec3(-0.6, 0, 0), axis = vec3.up, min_degrees = -60, max_degrees = 60, motor = { speed = 1, torque = 5 } }

local views = { "colliders", "joints", "boxes", "contacts", "rays", "velocities", "names", "physics" }

function update(dt)
  physics.debug_view = views[math.floor(time.now / 3) % #views + 1]
  physics.raycast(vec3(-4, 0.3, 0.2), vec3.right, 8)
end
