-- Watch: a whole day in twenty seconds. The sky's colours light the scene from above and below, fog fades what is far
-- into the horizon, and the sun is a light that turns.
scene.add { name = "camera", position = vec3(0, 2, 10), camera = {} }
scene.add { name = "floor", color = "darkseagreen", mesh = { shape = "plane", size = vec3(200, 1, 200) } }
for i = 1, 60 do
  local place = random.in_sphere(60):with_y(0)
  scene.add { name = "tree " .. i, position = place + vec3(0, 1.5, -30), color = color.hsv(random.between(0.25, 0.4), 0.5, 0.5),
    mesh = { shape = "cone", radius = 1, height = 3 } }
end
local sun = scene.add { name = "sun", light = "sun" }
local day = scene.add { name = "day", sky = { fog_start = 10, fog_end = 70 } }

local hours = { { top = "#0b1030", horizon = "#1b2040", sun = 0 }, { top = "#3c4f8a", horizon = "#ff9a5c", sun = 0.5 },
  { top = "#3f8edb", horizon = "#cfe4f5", sun = 1 }, { top = "#4a3c7a", horizon = "#ff7a4a", sun = 0.4 } }
local function mixed(name, a, b, t) return color(a[name]):lerp(color(b[name]), t) end

function update(dt)
  local hour = time.now / 5 % 4                                            -- five seconds each
  local a, b, t = hours[math.floor(hour) + 1], hours[math.floor(hour + 1) % 4 + 1], hour % 1
  day.sky.top, day.sky.horizon = mixed("top", a, b, t), mixed("horizon", a, b, t)
  sun.light.brightness = math.lerp(a.sun, b.sun, t)
  sun.rotation_degrees = vec3(-15 - 60 * math.max(0, math.sin(hour / 4 * 2 * math.pi - math.pi / 2)), 40 - hour * 20, 0)
end
