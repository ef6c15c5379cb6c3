-- Watch: chance is seeded, so the same game with the same presses is the same every time: leave and start again, and
-- the first throw comes out alike. Space throws; the bars count what lay on top.
local dice, counts = {}, { 0, 0, 0, 0, 0, 0 }
local faces = { vec3.up, vec3.forward, vec3.right, vec3.left, vec3.back, vec3.down }    -- opposite sides make seven

scene.add { name = "camera", position = vec3(0, 5, 5), rotation_degrees = vec3(-42, 0, 0), camera = {} }
scene.add { name = "table", position = vec3(0, -0.1, 0), color = "darkgreen", mesh = { shape = "box", size = vec3(10, 0.2, 7) }, body = "static" }
scene.add { name = "rim", position = vec3(0, 0.2, -3.4), color = "saddlebrown", mesh = { shape = "box", size = vec3(10, 0.6, 0.2) }, body = "static" }
for i = 1, 5 do
  dice[i] = scene.add { name = "die " .. i, position = vec3(i - 3, 1, 0), color = "ivory",
    mesh = { shape = "box", size = vec3(0.4, 0.4, 0.4) }, body = { mass = 0.05, restitution = 0.3 } }
end

local function top_of(die)
  local best = 1
  for i, face in ipairs(faces) do
    if (die.rotation * face).y > (die.rotation * faces[best]).y then best = i end
  end
  return best
end

local function throw()
  for i, die in ipairs(dice) do
    die:teleport(vec3(i - 3, 1.5, 2), quat.axis_angle(random.direction(), random.between(0, 3)))
    die.body.velocity = vec3(random.between(-0.5, 0.5), 1, -3)
    die.body.angular_velocity = random.direction() * 15
  end
  wait(2.5)
  for _, die in ipairs(dice) do counts[top_of(die)] = counts[top_of(die)] + 1 end
end

function start() task.spawn(throw) end
function on_press(name)
  if name == "space" then task.spawn(throw) end
end
function draw_ui()
  for i, count in ipairs(counts) do ui.text(("%d: %d"):format(i, count), { x = 30, y = 20 + i * 34 }) end
end
