-- Watch: balls run down between the hills. A height field is ground made from a picture: where the picture is bright, the
-- ground is high. Paint over hills.png and save: the ground and its collider follow at once.
scene.add { name = "camera", position = vec3(0, 4.6, 9.6), rotation_degrees = vec3(-26, 0, 0), camera = {} }
scene.add { name = "sun", rotation_degrees = vec3(-28, 65, 0), light = { type = "sun", color = "#fff0d0" } }

-- Black lies at the bottom of the size and white at its top, whatever the picture's own size. A mesh without colliders
-- of its own is also what the body feels.
scene.add { name = "hills", material = { color = "#8fae5a", roughness = 1 },
  mesh = { shape = "height_field", file = "hills.png", size = vec3(14, 4, 10) }, body = { type = "static", friction = 0.8 } }

local function drop()
  local ball = scene.add { position = vec3(random.between(-5, 5), 3.5, random.between(-4.6, -3.5)),
    color = color.hsv(random.between(0, 1), 0.7, 1),
    mesh = { shape = "sphere", radius = random.between(0.12, 0.25) }, body = { density = 500, friction = 0.8 } }
  task.after(12, ball.destroy, ball)
end

function start() task.every(0.3, drop) end
