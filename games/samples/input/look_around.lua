-- Watch: click, and the pointer turns your head, as far round as you like; w a s d walk. Escape gives the pointer back.
local speed = 3              -- m/s
local turn_speed = 0.004     -- radians for one ui unit of the pointer
local yaw, pitch = 0, 0

local eye = scene.add { name = "eye", position = vec3(0, 1.7, 0), camera = {} }
scene.add { name = "floor", mesh = { shape = "plane", size = vec3(30, 1, 30) }, color = "darkseagreen" }
for i = 0, 11 do
  local around = quat.axis_angle(vec3.up, i * math.pi / 6)
  scene.add { name = "stone " .. i, position = around * vec3(0, 1, -8), rotation = around,
    mesh = { shape = "box", size = vec3(1.2, 2, 0.6) }, color = color.hsv(i / 12, 0.4, 0.8) }
end

function on_press(name)
  if name == "pointer" then input.pointer.captured = true end
  if name == "escape" then input.pointer.captured = false end
end

function update(dt)
  if input.pointer.captured then
    yaw = yaw - input.pointer.dx * turn_speed
    pitch = math.clamp(pitch - input.pointer.dy * turn_speed, -1.4, 1.4)
    eye.rotation = quat.axis_angle(vec3.up, yaw) * quat.axis_angle(vec3.right, pitch)
  end
  local walk = vec3(input.axis("left", "right"), 0, input.axis("forward", "back")):clamped(1)
  eye:translate(quat.axis_angle(vec3.up, yaw) * walk, speed * dt)
end

function draw_ui()
  ui.text(input.pointer.captured and "escape: free the pointer" or "click to look around", { at = "bottom", size = 28 })
end
