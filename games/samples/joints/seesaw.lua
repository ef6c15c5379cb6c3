-- Watch: a heavy box falls on one end, and the light one flies off the other. The board turns about a hinge, no further
-- than its limits; F3 shows them as an arc.
scene.add { name = "camera", position = vec3(0, 2.5, 8), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(12, 0.2, 6) }, body = "static" }
local foot = scene.add { name = "foot", position = vec3(0, 0.4, 0), color = "slategray",
  mesh = { shape = "pyramid", size = vec3(0.8, 0.8, 1) }, body = "static" }
local board = scene.add { name = "board", position = vec3(0, 0.85, 0), color = "burlywood",
  mesh = { shape = "box", size = vec3(5, 0.1, 1) }, body = { mass = 8, friction = 0.9 } }
local hinge = joint.hinge { a = board, b = foot, anchor = vec3.zero, axis = vec3.back, min_degrees = -15, max_degrees = 15,
  collide_connected = false }

scene.add { name = "light", position = vec3(-2.1, 1.1, 0), color = "gold", mesh = { shape = "box", size = vec3(0.4, 0.4, 0.4) },
  body = { mass = 2 } }
scene.add { name = "heavy", position = vec3(2, 4.5, 0), color = "firebrick", mesh = { shape = "box", size = vec3(0.7, 0.7, 0.7) },
  body = { mass = 30 } }

function update(dt) log.watch("board, degrees", math.round(hinge.angle_degrees)) end
