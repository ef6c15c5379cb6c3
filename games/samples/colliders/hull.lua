-- Watch: a hull is the tightest skin around some points, without hollows: here each stone is the hull of twenty points
-- thrown at random, so no two roll alike. Space loosens ten at once.
scene.add { name = "camera", position = vec3(-0.4, 3.2, 7), rotation_degrees = vec3(-14, 4, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkolivegreen",
  mesh = { shape = "box", size = vec3(16, 0.2, 10) }, body = { type = "static", friction = 0.9 } }
scene.add { name = "slope", position = vec3(-2.6, 1.2, 0), rotation_degrees = vec3(0, 0, -32), color = "dimgray",
  mesh = { shape = "box", size = vec3(6, 0.4, 4) }, body = { type = "static", friction = 0.9 } }
scene.add { name = "fence", position = vec3(2.6, 0.35, 0), color = "saddlebrown",
  mesh = { shape = "box", size = vec3(0.15, 0.7, 4) }, body = "static" }

local function stone()
  local size = vec3(random.between(0.2, 0.5), random.between(0.2, 0.35), random.between(0.2, 0.45))
  local points = {}
  for i = 1, 20 do points[i] = random.direction() * size end
  local grey = random.between(0.45, 0.8)
  local node = scene.add { position = vec3(-4.4, 3.4, random.between(-1.4, 1.4)), color = color(grey, grey * 0.95, grey * 0.88),
    rotation = quat.axis_angle(random.direction(), random.between(0, 3)),
    mesh = { shape = "hull", points = points },                  -- the collider is fitted to it
    body = { density = 2600, friction = 0.9 } }
  task.after(14, node.destroy, node)
end

function start() task.every(0.5, stone) end
function on_press(name)
  if name ~= "space" then return end
  for i = 1, 10 do task.after(i * 0.1, stone) end
end
