-- Watch: a sphere meets everything at one point and is alike from all sides, so that every ball falls its own way through
-- the pins, and many make a bell. It is the cheapest collider. Space drops a handful.
scene.add { name = "camera", position = vec3(0, 2.6, 6.2), camera = {} }
scene.add { name = "back", position = vec3(0, 2.6, -0.25), color = "#27405c", mesh = { shape = "box", size = vec3(4.6, 5.4, 0.1) } }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "peru",
  mesh = { shape = "box", size = vec3(4.6, 0.2, 0.5) }, body = "static" }
for i = 0, 11 do
  local height = (i == 0 or i == 11) and 5.3 or 1.5
  scene.add { position = vec3((i - 5.5) * 0.4, height / 2, 0), color = "peru",
    mesh = { shape = "box", size = vec3(0.05, height, 0.4) }, body = "static" }
end
for row = 1, 8 do
  for i = 1, 10 - row % 2 do
    scene.add { position = vec3((i - 5.5 + row % 2 / 2) * 0.4, 1.4 + row * 0.36, 0), color = "gold",
      mesh = { shape = "sphere", radius = 0.05 }, body = { type = "static", restitution = 0.4 } }
  end
end

local function drop()
  local ball = scene.add { position = vec3(random.between(-0.05, 0.05), 5.2, 0), color = color.hsv(random.between(0, 1), 0.6, 0.95),
    mesh = { shape = "sphere", radius = 0.1 }, body = { mass = 0.1, friction = 0.2, lock_position = "z" } }
  task.after(40, ball.destroy, ball)
end

function start() task.every(0.3, drop) end
function on_press(name)
  if name ~= "space" then return end
  for i = 1, 8 do task.after(i * 0.08, drop) end
end
