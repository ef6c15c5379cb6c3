-- What stands around the court, a schoolyard at dusk: fence, lamps, bleachers with people, trees, the town behind.
-- Only declarations, and nothing here counts in the game but the fence, which keeps the ball in.
local steel = "#3b3650"

scene.add { name = "sun", rotation_degrees = vec3(-32, 58, 0), light = { color = "#ffc48a", brightness = 1.1 } }
scene.add { name = "sky", sky = { top = "#39417f", horizon = "#ff9f73", ground = "#4a3f5c",
  fog_color = "#d98a80", fog_start = 25, fog_end = 160, brightness = 1.15, exposure = 1.15 } }

local function box(name, position, size, color, more)
  local node = more or {}
  node.name, node.position, node.mesh = name, position, { shape = "box", size = size }
  node.material = node.material or { color = color }
  return scene.add(node)
end
local function planks(name, position, size, parent)
  return box(name, position, size, nil, { parent = parent,
    material = { color = "#d9986a", texture = "textures/wood.png", texture_size = 0.9 } })
end
local function pole(name, position, radius, height, color)
  return scene.add { name = name, position = position + vec3.up * (height / 2), color = color,
    mesh = { shape = "cylinder", radius = radius, height = height } }
end

-- ---- the fence: posts, rails, and a wall that is not seen
local function fence(x, z, length, is_along_z)
  local height = 3.2
  local along = is_along_z and vec3.back or vec3.right
  local function size(thick, high) return is_along_z and vec3(thick, high, length) or vec3(length, high, thick) end
  for _, y in ipairs { 0.15, height / 2, height } do box("rail", vec3(x, y, z), size(0.05, 0.05), steel) end
  local posts = math.round(length / 3)
  for i = 0, posts do
    pole("fence post", vec3(x, 0, z) + along * (length * (i / posts - 0.5)), 0.045, height, steel)
  end
  scene.add { name = "netting", position = vec3(x, height / 2, z), mesh = { shape = "box", size = size(0.01, height) },
    material = { color = "#8d86a8", texture = "textures/fence.png", texture_size = 0.4 } }
  scene.add { name = "fence", position = vec3(x, 3, z), body = { type = "static", restitution = 0.4,
    colliders = { shape = "box", size = size(0.2, 6) } } }
end
fence(0, -8.6, 24, false)
fence(-12, 1, 19.2, true)
fence(12, 1, 19.2, true)

-- ---- lamps at the corners
for _, place in ipairs { vec3(-7.6, 0, -7.8), vec3(7.6, 0, -7.8), vec3(-9, 0, 6), vec3(9, 0, 6) } do
  local inwards = vec3(-math.sign(place.x), 0, 0)
  pole("lamp post", place, 0.07, 6, steel)
  box("lamp arm", place + vec3.up * 6 + inwards * 0.6, vec3(1.3, 0.07, 0.07), steel)
  scene.add { name = "lamp", position = place + vec3.up * 5.93 + inwards * 1.2, material = { color = "#ffe2ad", glow = 1.2 },
    mesh = { shape = "box", size = vec3(0.7, 0.1, 0.3) },
    light = { type = "point", color = "#ffcf8f", brightness = 2, range = 14, shadow = false } }
end

-- ---- bleachers on both sides, and people on them
local shirts = { "#e2594a", "#f2b441", "#49a6b8", "#7d6bc4", "#eee3d0", "#5fae77" }
local skins = { "#f0c8a0", "#d39d6f", "#8a5a3c", "#b57a50" }
local function bleachers(name, x, z, turn_degrees)
  local stand = scene.add { name = name, position = vec3(x, 0, z), rotation_degrees = vec3(0, turn_degrees, 0) }
  for row = 0, 2 do
    planks("bench", vec3(0, 0.42 + row * 0.4, -row * 0.75), vec3(6, 0.07, 0.45), stand)
    planks("step", vec3(0, 0.2 + row * 0.4, -row * 0.75 - 0.45), vec3(6, 0.06, 0.4), stand)
    for _, side in ipairs { -2.7, 0, 2.7 } do
      box("leg", vec3(side, 0.2 + row * 0.2, -row * 0.75), vec3(0.07, 0.4 + row * 0.4, 0.35), steel, { parent = stand })
    end
  end
  return stand
end
local function people(stand, count)
  local crowd = scene.add { name = "people", parent = stand, behaviours = { crowd = {} } }
  for i = 0, count - 1 do
    local row, seat = i % 3, i // 3
    scene.add { parent = crowd, position = vec3(-2.4 + 1.15 * seat + 0.3 * row, 0.46 + 0.4 * row, -0.75 * row),
      scale = vec3.one * random.between(0.85, 1.1), children = {
        { position = vec3(0, 0.3, 0), color = random.choice(shirts),
          mesh = { shape = "capsule", radius = 0.17, height = 0.62 } },
        { position = vec3(0, 0.74, 0), color = random.choice(skins), mesh = { shape = "sphere", radius = 0.13 } } } }
  end
end
people(bleachers("bleachers", -8.2, -3.6, 72), 14)
people(bleachers("bleachers", 8.4, -2.8, -76), 9)

scene.add { name = "evening", position = vec3(0, 3, 0),
  sound = { file = "sounds/evening.ogg", volume = 0.4, range = 200, loop = true, playing = true } }

-- ---- the scoreboard
local board = box("scoreboard", vec3(5, 4.5, -8.1), vec3(4.4, 1.3, 0.2), "#231d30", { behaviours = { scoreboard = {} } })
box("roof", vec3(0, 0.68, 0), vec3(4.5, 0.08, 0.34), "#e2594a", { parent = board })
for _, x in ipairs { 3.4, 6.6 } do pole("scoreboard post", vec3(x, 0, -8.25), 0.07, 4.6, steel) end

-- ---- clouds, lit from below
for i = 1, 6 do
  local place = vec3(-75 + 28 * i + random.between(-8, 8), random.between(30, 44), -100)
  local cloud = scene.add { name = "cloud", position = place }
  for puff = -1, 1 do
    scene.add { parent = cloud, position = vec3(7 * puff, random.between(-1, 1), 0), scale = vec3(1, 0.3, 0.6),
      material = { color = "#e8a79c", roughness = 1 }, mesh = { shape = "sphere", radius = random.between(4.5, 7) } }
  end
end

-- ---- trees behind the fence, then the town
for i = 1, 12 do
  local place = vec3(-22 + 4 * (i - 1) + random.between(-1.2, 1.2), 0, random.between(-13, -10.5))
  local size = random.between(1.2, 1.9)
  pole("trunk", place, 0.13, 2.2, "#4a3340")
  scene.add { name = "crown", position = place + vec3.up * (2 + size * 0.6), scale = vec3(1, 0.85, 1),
    color = random.choice { "#3f6b5c", "#4c7a58", "#35594f" }, mesh = { shape = "sphere", radius = size } }
end
for i = 1, 26 do
  local height, depth = random.between(6, 22), random.between(30, 55)
  box("house", vec3((i - 13.5) * 5.2 + random.between(-1, 1), height / 2, -depth), vec3(random.between(4.5, 7), height, 5), nil,
    { material = { texture = "textures/windows.png", texture_size = 9, glow = 0.35 } })
end
box("ground", vec3(0, -0.3, -20), vec3(160, 0.2, 90), "#3d3a4d")
