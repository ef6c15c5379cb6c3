-- Watch: a box stands until its middle is past its edge, and slides when the slope is steeper than its friction. The low
-- one can only slide, the tall one tips, and the rough cube waits for 45 degrees. Then all begins again.
scene.add { name = "camera", position = vec3(1.6, 3.6, 5.4), rotation_degrees = vec3(-17, 14, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "darkslategray",
  mesh = { shape = "box", size = vec3(20, 0.2, 12) }, body = "static" }

-- You move a kinematic body, and it carries what lies on it.
local board = scene.add { name = "board", position = vec3(0, 2, 0), color = "burlywood",
  mesh = { shape = "box", size = vec3(5, 0.15, 4) }, body = { type = "kinematic", friction = 1 } }

-- The collider is fitted to the mesh: one size says what is seen and what is hit.
local function box(name, z, size, friction, color)
  scene.add { name = name, tags = "box", position = vec3(-1.2, 2.08 + size.y / 2, z), color = color,
    mesh = { shape = "box", size = size }, body = { density = 500, friction = friction } }
end
box("low", 1.3, vec3(1.2, 0.25, 0.7), 0.5, "skyblue")              -- slides at 27 degrees, where tan is 0.5
box("tall", -1.3, vec3(0.4, 1.2, 0.7), 1.2, "tomato")              -- tips at 18 degrees, where tan is 0.4 / 1.2
box("cube", 0, vec3(0.6, 0.6, 0.6), 1.2, "gold")                   -- tips at 45 degrees

local tilt = 0
function update(dt)
  tilt = tilt + 5 * dt                                             -- degrees
  board.rotation_degrees = vec3(0, 0, -math.clamp(tilt, 0, 46))
  if tilt > 60 then
    tilt = -5
    scene.restart()
  end
  for _, node in ipairs(scene.tagged("box")) do draw.text(node.position + vec3(0, 0.8, 0), node.name) end
  log.watch("slope, degrees", math.round(math.clamp(tilt, 0, 46)))
end
