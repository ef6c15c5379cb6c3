-- Watch: six planes make a drum that turns and mixes balls. A plane is a floor or a wall: its surface is where the node
-- is, and its body a thin slab behind it. The wall in front is a collider only, so that we can look in.
scene.add { name = "camera", position = vec3(0, 2, 5), rotation_degrees = vec3(-7, 0, 0), camera = {} }
scene.add { name = "floor", color = "darkslateblue", mesh = { shape = "plane", size = vec3(30, 1, 30) }, body = "static" }

-- A plane faces along its y. Each wall is turned so that it faces inwards, and its offset pushes it out.
local width, colliders, walls = 2, {}, {}
local turns = { vec3(0, 0, 0), vec3(180, 0, 0), vec3(0, 0, 90), vec3(0, 0, -90), vec3(90, 0, 0), vec3(-90, 0, 0) }
for i, turn in ipairs(turns) do
  local offset = quat.euler_degrees(turn.x, turn.y, turn.z) * vec3(0, -width / 2, 0)
  colliders[i] = { shape = "plane", size = vec3(width, 1, width), offset = offset, rotation_degrees = turn, friction = 0.8 }
  walls[i] = { visible = i < 6, position = offset, rotation_degrees = turn, color = color.hsv(0.5 + i * 0.03, 0.5, 0.8),
    mesh = { shape = "plane", size = vec3(width, 1, width) } }
end
local drum = scene.add { name = "drum", position = vec3(0, 1.5, 0), children = walls,
  body = { type = "kinematic", colliders = colliders } }

for i = 1, 24 do
  scene.add { name = "ball " .. i, position = vec3((i % 4 - 1.5) * 0.35, 1 + i // 8 * 0.35, (i // 4 % 2 - 0.5) * 0.5),
    color = color.hsv(i / 24, 0.7, 1), mesh = { shape = "sphere", radius = 0.15 }, body = { mass = 0.2, restitution = 0.3 } }
end

function update(dt) drum:turn(vec3.back, dt) end
