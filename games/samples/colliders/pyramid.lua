-- Watch: the ground shakes harder and harder. A pyramid's middle is at a quarter of its height, a box's at a half: so
-- the pyramids stand where columns as wide and as high fall down. Then they are set up again.
scene.add { name = "camera", position = vec3(0, 2, 4.8), rotation_degrees = vec3(-16, 0, 0), camera = {} }
scene.add { name = "sky", sky = { top = "#4f7fc4", horizon = "#f2d7a0", ground = "#a98a5c" } }
scene.add { name = "desert", position = vec3(0, -0.4, 0), color = "burlywood",
  mesh = { shape = "box", size = vec3(40, 0.2, 20) }, body = "static" }
local ground = scene.add { name = "ground", position = vec3(0, -0.1, 0), color = "khaki",
  mesh = { shape = "box", size = vec3(6, 0.2, 3.2) }, body = { type = "kinematic", friction = 2 } }

for i = 1, 3 do
  local x, width, height = 2 - i, 0.35 + i * 0.1, 0.7 + i * 0.25
  scene.add { name = "pyramid", position = vec3(x * 1.6, height / 2, 0.6), color = "goldenrod",
    mesh = { shape = "pyramid", size = vec3(width, height, width) }, body = { density = 2000 } }
  scene.add { name = "column", position = vec3(x * 1.6, height / 2, -0.8), color = "lightgray",
    mesh = { shape = "box", size = vec3(width, height, width) }, body = { density = 2000 } }
end

local seconds = 0
function update(dt)
  seconds = seconds + dt
  local swing = 0.03 * math.clamp(seconds - 1, 0, 6)                                -- m, once in a second
  ground.position = vec3(swing * math.sin(seconds * 2 * math.pi), -0.1, 0)
  if seconds > 10 then
    seconds = 0
    scene.restart()
  end
end
