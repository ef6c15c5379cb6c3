-- Watch: each block is 27 cubes welded together, and a weld holds up to its `break_force`. The block that falls from low
-- stays whole, the other one bursts. Fixed joints make one thing of many bodies, for as long as it lasts.
local break_force = 250                                                   -- N

scene.add { name = "camera", position = vec3(-0.4, 2.6, 6.5), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "slategray",
  mesh = { shape = "box", size = vec3(16, 0.2, 10) }, body = "static" }

-- A cube for each place of 3 x 3 x 3, welded to its neighbours before it along x, y and z.
local function block(name, corner, turn, paint)
  local cubes = {}
  for i = 0, 26 do
    local x, y, z = i % 3, i // 3 % 3, i // 9
    cubes[i] = scene.add { name = name, position = corner + turn * vec3(x, y, z) * 0.4, rotation = turn,
      color = paint:lerp(color "white", i % 2 * 0.25), mesh = { shape = "box", size = vec3(0.4, 0.4, 0.4) }, body = { mass = 1 } }
    local function weld(to) joint.fixed { a = cubes[i], b = cubes[to], break_force = break_force } end
    if x > 0 then weld(i - 1) end
    if y > 0 then weld(i - 3) end
    if z > 0 then weld(i - 9) end
  end
end
local turn = quat.euler_degrees(20, 30, 0)
block("low", vec3(-2.8, 0.8, 0), turn, color "royalblue")
block("high", vec3(1.8, 5, 0), turn, color "tomato")

function start() task.every(6, scene.restart) end
