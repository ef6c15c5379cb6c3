-- Nodes: tree, names, transforms.
test("a child's place in the world follows from its parents' by scale, turn and shift", function()
  local top = scene.add { name = "top", position = vec3(1, 2, 3), rotation_degrees = vec3(0, 90, 0), scale = vec3(2, 2, 2) }
  local mid = scene.add { name = "mid", parent = top, position = vec3(1, 0, 0), rotation_degrees = vec3(0, 0, 90) }
  local low = scene.add { name = "low", parent = mid, position = vec3(0, 1, 0) }
  local about_y, about_z = quat.axis_angle(vec3.up, math.pi / 2), quat.axis_angle(vec3.back, math.pi / 2)
  local mid_world = vec3(1, 2, 3) + about_y * (vec3(1, 0, 0) * 2)
  expect(mid.world_position):near(mid_world, 1e-9)
  expect(low.world_position):near(mid_world + about_y * (about_z * (vec3(0, 1, 0) * 2)), 1e-9)
  expect(low.world_rotation * vec3.right):near(about_y * (about_z * vec3.right), 1e-9)
end)

test("to_world and to_local undo each other", function()
  local node = scene.add { position = vec3(3, -1, 2), rotation_degrees = vec3(10, 20, 30), scale = vec3(2, 3, 4) }
  local p = vec3(0.3, 0.7, -0.2)
  expect(node:to_local(node:to_world(p))):near(p, 1e-9)
  expect(node:to_world(vec3.zero)):near(node.world_position, 1e-12)
end)

test("writing a world pose sets the local one that leads there", function()
  local parent = scene.add { position = vec3(5, 0, 0), rotation_degrees = vec3(0, 45, 0) }
  local child = scene.add { parent = parent }
  child.world_position = vec3(1, 2, 3)
  expect(child.world_position):near(vec3(1, 2, 3), 1e-9)
  child.world_rotation = quat.axis_angle(vec3.right, 1)
  expect(child.world_rotation * vec3.up):near(quat.axis_angle(vec3.right, 1) * vec3.up, 1e-9)
end)

test("a node that is hung elsewhere keeps its place in the world", function()
  local far = scene.add { position = vec3(10, 5, 0), rotation_degrees = vec3(0, 30, 0) }
  local node = scene.add { position = vec3(1, 2, 3) }
  node.parent = far
  expect(node.world_position):near(vec3(1, 2, 3), 1e-9)
  expect(node.parent):equals(far)
  expect(#far.children):equals(1)
end)

test("forward, right and up are the node's own axes in the world", function()
  local node = scene.add { rotation_degrees = vec3(0, 90, 0) }
  expect(node.forward):near(vec3.left, 1e-9)
  expect(node.right):near(vec3.forward, 1e-9)
  expect(node.up):near(vec3.up, 1e-9)
  node:look_at(vec3(0, 0, 8))
  expect(node.forward):near(vec3.back, 1e-9)
end)

test("translate moves in the parent's space, turn about the node's own axis", function()
  local node = scene.add { position = vec3(1, 0, 0) }
  node:translate(vec3(2, 0, 0), 0.5)
  expect(node.position):near(vec3(2, 0, 0), 1e-12)
  node:turn(vec3.up, math.pi / 2)
  node:turn(vec3.right, math.pi / 2)
  expect(node.forward):near(vec3.up, 1e-9)
end)

test("rotation_degrees reads back what was written", function()
  local node = scene.add { rotation_degrees = vec3(20, -40, 60) }
  expect(node.rotation_degrees):near(vec3(20, -40, 60), 1e-6)
  node.rotation_degrees = vec3(-10, 170, 5)
  expect(node.rotation_degrees):near(vec3(-10, 170, 5), 1e-6)
end)

test("three numbers stand for a vec3 in every call", function()
  local node = scene.add {}
  node:set_position(1, 2, 3)
  local x, y, z = node:get_position()
  expect(vec3(x, y, z)):equals(vec3(1, 2, 3))
  node:translate(1, 1, 1)
  expect(node.position):equals(vec3(2, 3, 4))
end)

test("names and paths find nodes; find may miss, get may not", function()
  local level = scene.add { name = "level", children = { { name = "door", children = { { name = "handle" } } } } }
  expect(scene.get("level/door/handle").path):equals("level/door/handle")
  expect(level:get("handle").name):equals("handle")
  expect(scene.find("level/window")):equals(nil)
  expect(function() scene.get("level/windw") end):raises("no node 'level/windw'")
  expect(function() level:get("dor") end):raises("did you mean 'door'?")
end)

test("a name that fits two nodes is refused with both paths", function()
  scene.add { name = "cart", children = { { name = "wheel" } } }
  scene.add { name = "bike", children = { { name = "wheel" } } }
  expect(function() scene.get("wheel") end):raises("bike/wheel")
  expect(scene.get("cart/wheel").parent.name):equals("cart")
end)

test("tags find nodes in the order of the tree", function()
  scene.add { name = "a", tags = "coin", children = { { name = "b", tags = { "coin", "big" } } } }
  scene.add { name = "c", tags = "coin" }
  local names = {}
  for i, node in ipairs(scene.tagged("coin")) do names[i] = node.name end
  expect(table.concat(names, " ")):equals("a b c")
  expect(scene.get("b"):has_tag("big")):equals(true)
  expect(scene.get("c"):has_tag("big")):equals(false)
  expect(#scene.tagged("nothing of that name")):equals(0)
end)

test("a node is one value: found twice it is equal, and it is a key", function()
  local node = scene.add { name = "one" }
  expect(scene.get("one") == node):equals(true)
  local seen = { [node] = "yes" }
  expect(seen[scene.get("one")]):equals("yes")
end)

test("destroy takes effect at the end of the tick, and takes the children along", function()
  local parent = scene.add { name = "parent", children = { { name = "child" } } }
  local child = scene.get("child")
  parent:destroy()
  expect(parent.is_alive):equals(false)
  expect(child.is_alive):equals(false)
  expect(parent.name):equals("parent")                     -- still to be read in this tick
  wait(0.1)
  expect(scene.find("parent")):equals(nil)
  expect(function() return child.position end):raises("node 'child' was destroyed in ")
end)

test("a disabled node switches off its children", function()
  local record = require "record"
  local parent = scene.add { name = "parent", children = { { name = "child", behaviours = { witness = { label = "child" } } } } }
  wait(0.1)
  local witness = scene.get("child").behaviours.witness
  parent.enabled = false
  local count = witness.count
  wait(0.1)
  expect(witness.count):equals(count)
  parent.enabled = true
  wait(0.1)
  expect(witness.count):above(count)
  expect(record.lines[2]):equals("child start")
end)

test("a table whose __index is a node has the node's properties and methods", function()
  local node = scene.add { name = "core", position = vec3(1, 2, 3) }
  local shell = setmetatable({ layer = 1 }, { __index = node })
  local outer = setmetatable({}, { __index = shell })
  expect(shell.position):equals(vec3(1, 2, 3))
  expect(outer.name):equals("core")
  expect(outer.layer):equals(1)
  expect(outer.translate == node.translate):equals(true)
  outer.translate(node, vec3(1, 0, 0), 1)
  expect(outer.position):equals(vec3(2, 2, 3))
  expect(function() return outer.positon end):raises("node 'core' has no 'positon'; did you mean 'position'?")
end)

test("a function behind a table's __index gets that table", function()
  local middle = setmetatable({}, { __index = function(holder, name) return { holder, name } end })
  local object = setmetatable({}, { __index = middle })
  expect(object.any[1] == middle):equals(true)
  expect(object.any[2]):equals("any")
end)

test("what is wrong with a method's call or a property says so", function()
  local node = scene.add { name = "core", mesh = "box", body = { mass = 1 } }
  expect(function() node.translate(vec3.up) end):raises("node:translate: node expected before the colon, got vec3(0, 1, 0); was it called with a dot? Write node:translate(...)")
  expect(function() node.body.apply_force(node, vec3.up) end):raises("body:apply_force: body expected before the colon, got node 'core'; was it called with a dot?")
  expect(function() node:translat(vec3.up) end):raises("node 'core' has no 'translat'; did you mean 'translate'?")
  expect(function() node:apply_force(vec3.up) end):raises("node 'core' has no 'apply_force'; it belongs to the body: node.body:apply_force")
  expect(function() node.translate = print end):raises("node.translate is a function of every node and cannot be replaced")
  expect(function() node.body.apply_force = print end):raises("body.apply_force is a function of every body and cannot be replaced")
  expect(function() return node[1] end):raises("node 'core' has no '1'")
  expect(getmetatable(node)):equals("node")
end)

test("a handler's slot is read back, and empty before", function()
  local node = scene.add { name = "core" }
  expect(node.on_wake):equals(nil)
  local function hear() end
  node.on_wake = hear
  expect(node.on_wake == hear):equals(true)
end)

test("a component is added by a table, read in full and taken away by nil", function()
  local node = scene.add { name = "thing", mesh = "box" }
  expect(node.mesh.shape):equals("box")
  expect(node.mesh.size):equals(vec3(1, 1, 1))
  expect(node.body):equals(nil)
  node.body = { mass = 3 }
  expect(node.body.mass):equals(3)
  node.body.mass = 5
  expect(node.body.mass):equals(5)
  node.body = nil
  expect(node.body):equals(nil)
  node.color = "red"
  expect(node.material.color == color "red"):equals(true)
end)

test("scene.restart gives declared nodes their first state and takes added ones away", function()
  local floor = scene.get("floor")
  local before = floor.position
  floor.position = vec3(0, -3, 0)
  floor.color = "red"
  scene.add { name = "late" }
  scene.restart()
  wait(0.1)
  expect(floor.position):equals(before)
  expect(floor.color == color "red"):equals(false)
  expect(scene.find("late")):equals(nil)
  expect(scene.get("floor") == floor):equals(true)
end)

test("a camera shows a point where its own ray passes", function()
  local eye = scene.add { position = vec3(0, 1, 5), camera = {} }
  wait(0)
  local x, y, in_front = eye.camera:to_screen(vec3(0, 1, 0))
  expect(x):near(ui.width / 2, 1e-6)
  expect(y):near(360, 1e-6)
  expect(in_front):equals(true)
  x, y = eye.camera:to_screen(vec3(1, 2, -3))
  local from, to = eye.camera:ray(x, y)
  local way = (to - from):normalized()
  local off = vec3(1, 2, -3) - from
  expect((off - way * off:dot(way)):length()):near(0, 1e-6)
  expect(select(3, eye.camera:to_screen(vec3(0, 1, 9)))):equals(false)
end)

test("a component that another node has is copied where it is assigned or given", function()
  local old = scene.add { name = "old", mesh = { shape = "capsule", radius = 0.3, height = 2 }, material = { color = "red", glow = 1 },
    body = { mass = 3, friction = 0.1, colliders = { { shape = "sphere", radius = 0.4, offset = vec3(0, 1, 0) } } },
    light = { type = "point", range = 7 }, particles = { rate = 5, life = 2 } }
  local new = scene.add { name = "new", position = vec3(5, 0, 0), mesh = old.mesh }
  for _, part in ipairs { "material", "light", "body", "particles" } do new[part] = old[part] end
  expect(new.mesh.radius):equals(0.3)
  expect(new.material.glow):equals(1)
  expect(new.light.range):equals(7)
  expect(new.body.mass):equals(3)
  expect(new.body.colliders[1].offset):equals(vec3(0, 1, 0))
  expect(new.particles.rate):equals(5)

  old.mesh.radius = 0.2
  old.body.mass = 4
  expect(new.mesh.radius):equals(0.3)
  expect(new.body.mass):equals(3)
end)

test("a part of a component is copied too", function()
  local old = scene.add { name = "old", body = { colliders = { { shape = "sphere", radius = 0.4 }, { shape = "box" } } } }
  local new = scene.add { name = "new", position = vec3(5, 0, 0), body = { colliders = old.body.colliders } }
  new.body.colliders[2] = old.body.colliders[1]
  expect(#new.body.colliders):equals(2)
  expect(new.body.colliders[2].shape):equals("sphere")
end)

test("a component of a node that is gone cannot be copied", function()
  local old = scene.add { name = "old", mesh = "box" }
  local new = scene.add { name = "new" }
  local mesh = old.mesh
  old:destroy()
  wait(0)
  expect(function() new.mesh = mesh end):raises("was destroyed")
end)
