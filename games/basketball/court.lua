-- The court: only declarations, so every number in here can be changed while the ball flies.
-- Metres. The hoop hangs 4.2 m in front of the free-throw line, which is at z = 0; forward is -z.
local hoop = vec3(0, 3.05, -4.2)
local white, steel = "#f4efe2", "#4b4658"

-- ---- the floor and what is painted on it, layer on layer
local function asphalt(color) return { color = color, texture = "textures/asphalt.png", texture_size = 3 } end
scene.add { name = "floor", position = vec3(0, -0.1, 1), material = asphalt("#5a5474"),
  mesh = { shape = "box", size = vec3(30, 0.2, 24) }, body = { type = "static", restitution = 0.8 } }

local layers = 0
local function paint(name, x, z, width, depth, color, turn)
  layers = layers + 1
  return scene.add { name = name, position = vec3(x, 0.002 + layers * 0.0004, z), material = asphalt(color),
    rotation = quat.axis_angle(vec3.up, turn or 0), mesh = { shape = "box", size = vec3(width, 0.004, depth) } }
end

paint("court", 0, 1.1, 15, 13, "#2c8c8f")
paint("key", 0, -2.7, 3.6, 5.4, "#e0654f")
paint("base line", 0, -5.4, 15, 0.07, white)
for _, side in ipairs { -1, 1 } do
  paint("side line", side * 7.5, 1.1, 0.07, 13, white)
  paint("key line", side * 1.8, -2.7, 0.07, 5.4, white)
  paint("three-point line", side * 6.2, -4.8, 0.07, 1.2, white)
end
paint("free-throw line", 0, 0, 3.6, 0.07, white)

-- A line along a part of a circle, made of short straight ones.
local function paint_arc(name, z, radius, from_degrees, to_degrees, pieces)
  local step = math.rad(to_degrees - from_degrees) / pieces
  for i = 1, pieces do
    local turn = math.rad(from_degrees) + (i - 0.5) * step
    paint(name, radius * math.sin(turn), z + radius * math.cos(turn), radius * step * 1.02, 0.07, white, turn)
  end
end
paint_arc("three-point line", -4.2, 6.2, -90, 90, 30)
paint_arc("free-throw circle", 0, 1.8, -90, 90, 14)

-- ---- where to throw from, in turn
local spots = {
  { x = 0, z = 0, points = 2 },
  { x = -2.6, z = -1, points = 2 },
  { x = 2.6, z = -1, points = 2 },
  { x = 0, z = 2.5, points = 3 },
  { x = -4.4, z = 0.85, points = 3 },
  { x = 4.4, z = 0.85, points = 3 },
}
for i, spot in ipairs(spots) do
  scene.add { name = "spot " .. i, tags = "spot", position = vec3(spot.x, 0.02, spot.z), color = "#ffc65a",
    mesh = { shape = "cylinder", radius = 0.22, height = 0.01 }, behaviours = { spot = { points = spot.points } } }
end

-- ---- the ball bounces by what it hits: of two restitutions the larger one counts
local ball = scene.add { name = "ball", position = vec3(0, 1.5, 0), behaviours = { aim = {}, ball = {} },
  body = { type = "kinematic", mass = 0.62, restitution = 0.2, continuous = true, group = "ball",
    colliders = { shape = "sphere", radius = 0.12 } } }
local skin = scene.add { name = "picture", tags = "replayed", parent = ball,
  material = { color = "#f5832e", texture = "textures/leather.png" }, mesh = { shape = "sphere", radius = 0.12 } }
for _, turn in ipairs { vec3(0, 0, 0), vec3(90, 0, 0), vec3(0, 0, 90) } do   -- seams, to see it spin
  scene.add { parent = skin, rotation_degrees = turn, color = "#3a1d14",
    mesh = { shape = "torus", radius = 0.1185, thickness = 0.006 } }
end
-- Burns while a streak counts most often.
scene.add { name = "fire", parent = skin, particles = { playing = false, rate = 80, life = 0.5,
  speed = 0.3, spread_degrees = 180, gravity_factor = -0.2, area = vec3(0.1, 0.1, 0.1), size = 0.2,
  color = "#ffc04a", color_end = color("#e2402a"):with_alpha(0), glow = 1 } }
scene.add { name = "arc", behaviours = { arc = {} } }

-- ---- the hoop: board, ring, net
scene.add { name = "post", position = vec3(0, 1.7, -6), color = steel,
  mesh = { shape = "cylinder", radius = 0.11, height = 3.4 }, body = "static" }
scene.add { name = "arm", position = vec3(0, 3.35, -5.3), color = steel,
  mesh = { shape = "box", size = vec3(0.14, 0.14, 1.4) }, body = "static" }
local board = scene.add { name = "board", position = vec3(0, 3.45, -4.6), color = "#f7f3ea",
  mesh = { shape = "box", size = vec3(1.8, 1.05, 0.05) }, body = { type = "static", restitution = 0.6 } }
local function frame(width, height, y, thickness, color)
  for _, side in ipairs { -1, 1 } do
    scene.add { parent = board, position = vec3(side * width / 2, y, 0.026), color = color,
      mesh = { shape = "box", size = vec3(thickness, height + thickness, 0.012) } }
    scene.add { parent = board, position = vec3(0, y + side * height / 2, 0.026), color = color,
      mesh = { shape = "box", size = vec3(width - thickness, thickness, 0.012) } }
  end
end
frame(0.6, 0.44, -0.12, 0.045, "#e2483d")
frame(1.76, 1.01, 0, 0.05, "#2b3a67")
scene.add { name = "bracket", position = hoop + vec3(0, -0.01, -0.31), color = "#ff5a2a",
  mesh = { shape = "box", size = vec3(0.14, 0.05, 0.14) }, body = { type = "static", restitution = 0.4 } }
scene.add { name = "rim", position = hoop, color = "#ff5a2a",
  mesh = { shape = "torus", radius = 0.23, thickness = 0.03 }, body = { type = "static", restitution = 0.4 } }
scene.add { name = "net", position = hoop, behaviours = { net = {} } }

-- What counts: a narrow trigger on the ring's axis, which only a ball inside the ring can touch.
scene.add { name = "hoop", position = hoop, behaviours = { hoop = {} },
  body = { type = "static", trigger = true, colliders = { shape = "cylinder", radius = 0.06, height = 0.3 } } }

local confetti = scene.add { name = "confetti", position = hoop - vec3(0, 0.3, 0) }
for _, paper in ipairs { "#ffc65a", "#38c6d9", "#ff6b57", "#fbf6ea" } do
  scene.add { parent = confetti, particles = { playing = false, life = 1.6, speed = 4, spread_degrees = 75,
    gravity_factor = 0.4, size = 0.13, size_end = 0.1, color = paper, glow = 0.5 } }
end

-- ---- three plates to hit: each hangs from its frame on a hinge with a spring; the golden one tears off
local targets = {
  { position = vec3(-2.6, 2.6, -4.4), color = "#38c6d9", points = 1 },
  { position = vec3(2.6, 2.6, -4.4), color = "#38c6d9", points = 1 },
  { position = vec3(-4.9, 3.2, -5.4), color = "gold", points = 2, break_force = 40 },
}
for i, target in ipairs(targets) do
  local top = target.position
  local stand = scene.add { name = "stand " .. i, position = top, color = steel,
    mesh = { shape = "box", size = vec3(1.1, 0.06, 0.06) }, body = "static" }
  for _, side in ipairs { -0.55, 0.55 } do
    scene.add { parent = stand, position = vec3(side, -top.y / 2, 0), color = steel,
      mesh = { shape = "cylinder", radius = 0.035, height = top.y }, body = "static" }
  end
  local plate = scene.add { name = "plate " .. i, position = top - vec3(0, 0.5, 0),
    behaviours = { target = { points = target.points } },
    body = { mass = 1.5, restitution = 0.3, colliders = { shape = "box", size = vec3(0.8, 0.8, 0.06) } } }
  scene.add { name = "picture", tags = "replayed", parent = plate, color = target.color,
    mesh = { shape = "box", size = vec3(0.8, 0.8, 0.06) } }
  scene.add { name = "sparks", parent = plate, particles = { playing = false, life = 0.9, speed = 4, spread_degrees = 180,
    size = 0.16, color = "#fff0b0", color_end = "#ff9a3c", glow = 1, gravity_factor = 0.6 } }
  joint.hinge { name = "hinge", a = plate, b = stand, anchor = vec3(0, 0.5, 0), axis = vec3.right,
    min_degrees = -85, max_degrees = 85, spring = { frequency = 1.5, damping = 0.15 },
    break_force = target.break_force or math.huge }
end

-- ---- who looks after it all
scene.add { name = "replay", behaviours = { replay = {} } }
scene.add { name = "match", behaviours = { match = {} } }
scene.add { name = "camera rig", position = vec3(0, 2.6, 3.8), behaviours = { cameraman = {} }, children = {
  { name = "camera", camera = { field_of_view_degrees = 48 },
    behaviours = { shake = { distance = 0.12, turn_degrees = 2 } } } } }
