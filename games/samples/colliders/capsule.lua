-- Watch: three figures are pushed alike over sills and a step. The round foot of the capsule slides up where the box and
-- the cylinder stop at the edge. That is why people, who walk over such things, are capsules.
scene.add { name = "camera", position = vec3(0.4, 2.8, 6.3), rotation_degrees = vec3(-20, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "slategray",
  mesh = { shape = "box", size = vec3(14, 0.2, 6) }, body = { type = "static", friction = 0.3 } }
for i = 0, 2 do
  scene.add { name = "sill", position = vec3(i * 1.5 - 2, 0, 0), color = "saddlebrown",
    mesh = { shape = "cylinder", radius = 0.05 + i * 0.03, height = 5 }, rotation_degrees = vec3(90, 0, 0), body = "static" }
end
scene.add { name = "step", position = vec3(4.5, 0.04, 0), color = "rosybrown",
  mesh = { shape = "box", size = vec3(5, 0.08, 5) }, body = "static" }

-- A figure keeps upright: it must not turn about any axis.
local function figure(shape, z, color)
  return scene.add { name = shape.shape, tags = "figure", position = vec3(-4.5, 0.71, z), color = color, mesh = shape,
    body = { mass = 60, friction = 0.3, lock_rotation = "xyz", can_sleep = false } }
end
figure({ shape = "box", size = vec3(0.6, 1.4, 0.6) }, -1.5, "tomato")
figure({ shape = "cylinder", radius = 0.3, height = 1.4 }, 0, "gold")
figure({ shape = "capsule", radius = 0.3, height = 1.4 }, 1.5, "limegreen")    -- the height is over all, round ends too

-- A push that keeps it at 1.5 m/s, of at most 800 N.
function update(dt)
  for _, node in ipairs(scene.tagged("figure")) do
    local body = node.body
    body:apply_force(vec3(math.clamp((1.5 - body.velocity.x) * 1000, 0, 800), 0, 0))
    draw.text(node.position + vec3(0, 1, 0), node.name)
  end
end

function start() task.every(7, scene.restart) end
