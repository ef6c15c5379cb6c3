-- Watch: a figure tumbles down the steps. Its limbs bend as limbs do: shoulders, hips and neck swing within cones and
-- hardly twist, elbows and knees are hinges. F3 shows the cones. Space drops another one.
scene.add { name = "camera", position = vec3(-0.3, 2.4, 5.6), rotation_degrees = vec3(-15, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(20, 0.2, 8) }, body = "static" }
for i = 0, 4 do
  local height = 2 - 0.4 * i
  scene.add { position = vec3(-2.5 + 0.7 * i, height / 2, 0), color = "slategray",
    mesh = { shape = "box", size = vec3(0.7, height, 4) }, body = "static" }
end

local function drop()
  local foot = vec3(-2.6, 2.3, random.between(-0.8, 0.8))
  local skin = color.hsv(random.between(0, 1), 0.5, 0.95)

  -- A limb whose upper end is at the given height and side, hung into another one.
  local function limb(above, side, top, length, radius, kind, options)
    local bone = scene.add { position = foot + vec3(0, top - length / 2, side), color = skin,
      mesh = { shape = "capsule", radius = radius, height = length }, body = { mass = 8 * length, angular_damping = 0.3 } }
    options.a, options.b, options.anchor = bone, above, vec3(0, length / 2, 0)
    joint[kind](options)
    return bone
  end

  local trunk = scene.add { position = foot + vec3(0, 1.15, 0), color = skin,
    mesh = { shape = "box", size = vec3(0.2, 0.6, 0.36) }, body = { mass = 12, angular_damping = 0.3 } }
  local head = scene.add { position = foot + vec3(0, 1.62, 0), color = skin, mesh = { shape = "sphere", radius = 0.14 }, body = { mass = 3 } }
  joint.ragdoll { a = head, b = trunk, anchor = vec3(0, -0.15, 0), axis = vec3.up, swing_a = { max_degrees = 40 },
    swing_b = { max_degrees = 30 }, twist = { min_degrees = -50, max_degrees = 50 } }

  for _, side in ipairs { -1, 1 } do
    -- swing_a is about the z axis: forwards and backwards; swing_b is sideways
    local arm = limb(trunk, side * 0.25, 1.42, 0.36, 0.06, "ragdoll", { axis = vec3.down, swing_axis = vec3.back,
      swing_a = { max_degrees = 110 }, swing_b = { max_degrees = 60 }, twist = { min_degrees = -30, max_degrees = 30 } })
    limb(arm, side * 0.25, 1.08, 0.36, 0.05, "hinge", { axis = vec3.back, min_degrees = 0, max_degrees = 130 })
    local thigh = limb(trunk, side * 0.11, 0.86, 0.44, 0.08, "ragdoll", { axis = vec3.down, swing_axis = vec3.back,
      swing_a = { max_degrees = 80 }, swing_b = { max_degrees = 30 }, twist = { min_degrees = -15, max_degrees = 15 } })
    limb(thigh, side * 0.11, 0.43, 0.44, 0.06, "hinge", { axis = vec3.back, min_degrees = -130, max_degrees = 0 })
  end
  trunk.body.velocity = vec3(2.5, 0, 0)
end

function start() drop() end
function on_press(name)
  if name == "space" then drop() end
end
