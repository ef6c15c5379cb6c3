-- Watch: the red cart gets faster and faster, the yellow one is kicked once and then keeps its speed, and the
-- blue one is kicked as hard, but beside its middle: it goes as fast and spins as well.
scene.add { name = "camera", position = vec3(0, 7, 9), rotation_degrees = vec3(-36, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(20, 0.2, 8) }, body = { type = "static", friction = 0 } }

local function cart(name, z, color)
  return scene.add { name = name, position = vec3(-8, 0.25, z), color = color,
    mesh = { shape = "box", size = vec3(0.5, 0.5, 0.5) }, body = { mass = 2, friction = 0 } }
end
local pushed, kicked, beside = cart("pushed", -2, "tomato"), cart("kicked", 0, "gold"), cart("beside", 2, "skyblue")

function start()
  kicked.body:apply_impulse(vec3(4, 0, 0))                                   -- 4 N s on 2 kg: 2 m/s at once
  beside.body:apply_impulse(vec3(4, 0, 0), beside:to_world(vec3(0, 0, 0.2))) -- at a point of the world
end

function update(dt)
  pushed.body:apply_force(vec3(2, 0, 0))                       -- 2 N on 2 kg: 1 m/s more every second
  for _, node in ipairs { pushed, kicked, beside } do
    draw.text(node.position + vec3(0, 0.6, 0), ("%s %.2f m/s"):format(node.name, node.body.velocity.x))
  end
end
