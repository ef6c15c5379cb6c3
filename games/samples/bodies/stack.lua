-- Watch: a tower stands, and falls asleep: bodies at rest cost nothing until something touches them. Press space to
-- throw a ball at it.
scene.add { name = "camera", position = vec3(0, 2.5, 9), rotation_degrees = vec3(-6, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(20, 0.2, 20) }, body = "static" }

for row = 1, 8 do
  for column = 1, 3 do
    scene.add { name = ("brick %d %d"):format(row, column), tags = "brick", color = "indianred",
      position = vec3(column - 2 + row % 2 * 0.4 - 0.2, row * 0.4 - 0.2, 0),
      mesh = { shape = "box", size = vec3(0.98, 0.4, 0.5) }, body = { density = 600 } }
  end
end

function on_press(name)
  if name ~= "space" then return end
  local ball = scene.add { position = vec3(random.between(-1, 1), 1.5, 8), mesh = { shape = "sphere", radius = 0.25 },
    color = "black", body = { mass = 20, velocity = vec3(0, 2, -16) } }
  task.after(5, ball.destroy, ball)
end

function update(dt)
  for _, brick in ipairs(scene.tagged("brick")) do
    brick.color = brick.body.is_asleep and "rosybrown" or "indianred"
  end
  log.watch("awake", physics.stats().awake)
end
