-- Watch: a rope bridge of planks, each tied to the next by two ball joints. It sags under a load, and the load rolls to
-- its middle. Space drops another ball.
scene.add { name = "camera", position = vec3(0, 3, 8), rotation_degrees = vec3(-15, 0, 0), camera = {} }

local planks, width = 12, 0.5
local function plank(i, kind)
  return scene.add { name = "plank " .. i, position = vec3((i - (planks + 1) / 2) * width, 1.5, 0), color = "peru",
    mesh = { shape = "box", size = vec3(width - 0.06, 0.08, 1.6) }, body = { type = kind, mass = 3, angular_damping = 0.5 } }
end

local last = plank(0, "static")
for i = 1, planks + 1 do
  local next = plank(i, i <= planks and "dynamic" or "static")
  for _, z in ipairs { -0.7, 0.7 } do
    joint.ball { a = last, b = next, anchor = vec3(width / 2, 0, z) }    -- the anchor is in a's own coordinates
  end
  last = next
end

local function drop()
  local ball = scene.add { position = vec3(random.between(-2.5, 2.5), 4, 0), color = color.hsv(random.between(0, 1), 0.7, 0.95),
    mesh = { shape = "sphere", radius = 0.35 }, body = { mass = 5 } }
  task.after(10, ball.destroy, ball)
end

function start() task.after(1, drop) end
function on_press(name)
  if name == "space" then drop() end
end
