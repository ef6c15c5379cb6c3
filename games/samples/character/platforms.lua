-- Watch: boxes ride on three platforms, though none is tied to them: a kinematic body that is given positions has the
-- speed of that motion, and friction does the rest. Near the rim of the turning one it must hold more, so boxes slip.
scene.add { name = "camera", position = vec3(0, 5, 10), rotation_degrees = vec3(-22, 0, 0), camera = {} }
local function platform(name, x, settings)
  local node = scene.add { name = name, position = vec3(x, 0.5, 0), color = "skyblue", mesh = { shape = "cylinder", radius = 1.4, height = 0.3 },
    body = { type = "kinematic", friction = 0.8 }, behaviours = { platform = settings } }
  for i = 0, 2 do
    scene.add { name = ("%s box %d"):format(name, i), position = node.position + vec3(i * 0.5 - 0.1, 0.4, 0), color = "gold",
      mesh = { shape = "box", size = vec3(0.35, 0.35, 0.35) }, body = { mass = 1, friction = 0.8 } }
  end
end
platform("lift", -4, { travel = vec3(0, 2, 0), seconds = 2 })
platform("ferry", 0, { travel = vec3(0, 0, -3), seconds = 2.5 })
platform("carousel", 4, { turn_speed = 2.2 })
