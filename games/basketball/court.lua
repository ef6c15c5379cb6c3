-- The court: only declarations, so every number in here can be changed while the ball flies.
-- Metres. The ball waits at the free-throw line; the hoop hangs 4.2 m in front of it (forward is -z).
local hoop = vec3(0, 3.05, -4.2)

scene.add { name = "sun", rotation_degrees = vec3(-55, 35, 0), light = "sun" }
scene.add { name = "camera", position = vec3(0, 2.6, 3.8), rotation_degrees = vec3(-5, 0, 0),
  camera = { field_of_view_degrees = 48 } }

-- The ball bounces by what it hits: of two restitutions the larger one counts.
local ball = scene.add { name = "ball", position = vec3(0, 1.5, 0), color = "darkorange",
  mesh = { shape = "sphere", radius = 0.12 }, behaviours = { ball = {} },
  body = { type = "kinematic", mass = 0.62, restitution = 0.2, continuous = true, group = "ball" } }
for _, turn in ipairs { vec3(0, 0, 0), vec3(90, 0, 0), vec3(0, 0, 90) } do   -- seams, to see it spin
  scene.add { parent = ball, rotation_degrees = turn, color = "#402010", mesh = { shape = "torus", radius = 0.119, thickness = 0.005 } }
end

scene.add { name = "floor", position = vec3(0, -0.1, -2), color = "burlywood",
  mesh = { shape = "box", size = vec3(24, 0.2, 13) }, body = { type = "static", restitution = 0.8 } }

local function paint(name, position, size, color)
  scene.add { name = name, position = position, color = color, mesh = { shape = "box", size = size } }
end
paint("key", vec3(0, 0.002, -2.7), vec3(3.6, 0.01, 5.4), "firebrick")
paint("left line", vec3(-1.8, 0.004, -2.7), vec3(0.06, 0.01, 5.4), "white")
paint("right line", vec3(1.8, 0.004, -2.7), vec3(0.06, 0.01, 5.4), "white")
paint("base line", vec3(0, 0.004, -5.4), vec3(24, 0.01, 0.06), "white")

scene.add { name = "wall", position = vec3(0, 0.6, -8.4), color = "slategray",
  mesh = { shape = "box", size = vec3(24, 1.2, 0.2) }, body = { type = "static", restitution = 0.5 } }

-- ---- the hoop: board, ring, net
scene.add { name = "post", position = vec3(0, 1.7, -5.6), color = "dimgray",
  mesh = { shape = "cylinder", radius = 0.1, height = 3.4 }, body = "static" }
scene.add { name = "arm", position = vec3(0, 3.3, -5.1), color = "dimgray",
  mesh = { shape = "box", size = vec3(0.12, 0.12, 1) }, body = "static" }
local board = scene.add { name = "board", position = vec3(0, 3.45, -4.6), color = "white",
  mesh = { shape = "box", size = vec3(1.8, 1.05, 0.05) }, body = { type = "static", restitution = 0.6 } }
for _, bar in ipairs { vec3(-0.3, 0, 0), vec3(0.3, 0, 0), vec3(0, -0.22, 0), vec3(0, 0.22, 0) } do
  local upright = bar.x ~= 0
  scene.add { parent = board, position = bar + vec3(0, -0.12, 0.026), color = "crimson",
    mesh = { shape = "box", size = upright and vec3(0.04, 0.48, 0.01) or vec3(0.6, 0.04, 0.01) } }
end
scene.add { name = "bracket", position = hoop + vec3(0, -0.01, -0.3), color = "orangered",
  mesh = { shape = "box", size = vec3(0.12, 0.04, 0.14) }, body = { type = "static", restitution = 0.4 } }
scene.add { name = "rim", position = hoop, color = "orangered",
  mesh = { shape = "torus", radius = 0.23, thickness = 0.03 }, body = { type = "static", restitution = 0.4 } }

-- What counts: a narrow trigger on the ring's axis, which only a ball inside the ring can touch.
scene.add { name = "hoop", position = hoop, behaviours = { hoop = {} },
  body = { type = "static", trigger = true, colliders = { shape = "cylinder", radius = 0.06, height = 0.3 } } }

-- The net is only to be looked at: strands that lean inwards.
local net = scene.add { name = "net", position = hoop }
for i = 1, 16 do
  local around = quat.axis_angle(vec3.up, i * math.pi / 8)
  for _, lean in ipairs { -35, 35 } do
    scene.add { parent = net, position = around * vec3(0.185, -0.19, 0), color = "whitesmoke",
      rotation = around * quat.euler_degrees(lean, 0, -14),
      mesh = { shape = "cylinder", radius = 0.006, height = 0.44 } }
  end
end

-- ---- three plates to hit: each hangs from its frame on a hinge with a spring; the golden one tears off
local spots = {
  { position = vec3(-2.6, 2.6, -4.2), color = "deepskyblue", points = 1 },
  { position = vec3(2.6, 2.6, -4.2), color = "deepskyblue", points = 1 },
  { position = vec3(-5, 3.2, -5.4), color = "gold", points = 2, break_force = 40 },
}
for i, spot in ipairs(spots) do
  local top = spot.position
  local frame = scene.add { name = "frame " .. i, position = top, color = "dimgray",
    mesh = { shape = "box", size = vec3(1.1, 0.06, 0.06) }, body = "static" }
  for _, side in ipairs { -0.55, 0.55 } do
    scene.add { parent = frame, position = vec3(side, -top.y / 2, 0), color = "dimgray",
      mesh = { shape = "cylinder", radius = 0.04, height = top.y }, body = "static" }
  end
  local plate = scene.add { name = "plate " .. i, position = top - vec3(0, 0.5, 0), color = spot.color,
    mesh = { shape = "box", size = vec3(0.8, 0.8, 0.06) }, behaviours = { target = { points = spot.points } },
    body = { mass = 1.5, restitution = 0.3 } }
  joint.hinge { name = "hinge", a = plate, b = frame, anchor = vec3(0, 0.5, 0), axis = vec3.right,
    min_degrees = -85, max_degrees = 85, spring = { frequency = 1.5, damping = 0.15 },
    break_force = spot.break_force or math.huge }
end
