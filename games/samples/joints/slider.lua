-- Watch: three plungers are drawn down by their motors, then let go, and their springs throw the balls up. A slider moves
-- along its axis and no other way; the stiffer its spring, the higher the ball. Space lets go at once.
scene.add { name = "camera", position = vec3(0, 2.1, 5.4), rotation_degrees = vec3(-3, 0, 0), camera = {} }
scene.add { name = "back", position = vec3(0, 2.3, -0.5), color = "#3c3357", mesh = { shape = "box", size = vec3(4.4, 5.4, 0.1) } }
scene.add { name = "table", position = vec3(0, -0.3, 0), color = "saddlebrown",
  mesh = { shape = "box", size = vec3(4.4, 0.2, 1) }, body = "static" }

local sliders = {}
for i, frequency in ipairs { 3.5, 4.25, 5 } do                                        -- Hz
  local x = (i - 2) * 1.3
  local tube = scene.add { name = "tube", position = vec3(x, 0, 0), material = { color = "lightblue", opacity = 0.25 },
    mesh = { shape = "cylinder", radius = 0.24, height = 0.5 }, body = "static" }
  local plunger = scene.add { name = "plunger", position = vec3(x, 0.6, 0), color = "silver",
    mesh = { shape = "cylinder", radius = 0.2, height = 0.9 }, body = { mass = 4, can_sleep = false } }
  local slider = joint.slider { a = plunger, b = tube, axis = vec3.up, min = -0.6, max = 0.15 }
  sliders[i] = { joint = slider, spring = { frequency = frequency, damping = 0.3 } }
  scene.add { name = "ball", position = vec3(x, 1.4, 0), color = color.hsv(i / 4, 0.7, 1),
    mesh = { shape = "sphere", radius = 0.22 }, body = { mass = 0.5, lock_position = "xz" } }
end

local function draw_back()
  for _, slider in ipairs(sliders) do
    slider.joint.spring = nil
    slider.joint.motor = { target = -0.55, speed = 0.5, force = 500 }
  end
end
local function release()
  for _, slider in ipairs(sliders) do
    slider.joint.motor = nil
    slider.joint.spring = slider.spring
  end
end

function start()
  task.loop(function()
    draw_back()
    wait(1.5)
    release()
    wait(2.5)
  end)
end
function on_press(name)
  if name == "space" then release() end
end
function update(dt) log.watch("slide, m", sliders[1].joint.position) end
