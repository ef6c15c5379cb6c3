-- Watch: a touch at one end, and all fall, one by one. Space sets them up again: every node goes back to where this
-- file put it.
scene.add { name = "camera", position = vec3(0, 4, 6), rotation_degrees = vec3(-35, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(12, 0.2, 8) }, body = "static" }

local stones = 40
for i = 1, stones do
  local angle = (i - 1) / stones * 1.5 * math.pi                         -- three quarters of a circle
  scene.add { name = "stone " .. i, position = vec3(math.cos(angle), 0, math.sin(angle)) * 2 + vec3(0, 0.3, 0),
    rotation = quat.axis_angle(vec3.up, -angle), color = color.hsv(i / stones, 0.6, 0.95),
    mesh = { shape = "box", size = vec3(0.3, 0.6, 0.08) }, body = { mass = 0.2, friction = 0.4 } }
end

local function touch()
  local first = scene.get("stone 1")
  first.body:apply_impulse(vec3(0, 0, 0.1), first:to_world(vec3(0, 0.3, 0)))
end

function start() task.after(1, touch) end
function on_press(name)
  if name ~= "space" then return end
  scene.restart()
  task.after(1, touch)
end
