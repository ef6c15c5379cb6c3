-- Watch: s slows time, p stops it, and the full stop goes on by a single tick; v shows what the physics sees. Slow motion runs
-- fewer ticks, not shorter ones, so the tower falls the same way at any speed.
local views = { "none", "colliders", "joints", "boxes", "contacts", "physics" }
local view = 1

scene.add { name = "camera", position = vec3(4, 3.5, 8), rotation_degrees = vec3(-14, 26, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(20, 0.2, 20) }, body = "static" }
for i = 0, 19 do
  local across = i // 2 % 2 == 0
  local side = (i % 2 - 0.5) * 0.9
  scene.add { name = "plank " .. i, color = color.hsv(0.08 + i * 0.005, 0.6, 0.9),
    position = vec3(across and 0 or side, 0.15 + (i // 2) * 0.3, across and side or 0),
    mesh = { shape = "box", size = across and vec3(1.2, 0.3, 0.3) or vec3(0.3, 0.3, 1.2) }, body = { mass = 1 } }
end
scene.add { name = "ball", position = vec3(-6, 1.2, 0), color = "black", mesh = { shape = "sphere", radius = 0.35 },
  body = { mass = 8, velocity = vec3(9, 2.5, 0) } }

function on_press(name)
  if name == "s" then time.scale = time.scale == 1 and 0.2 or 1 end
  if name == "p" then time.paused = not time.paused end
  if name == "period" and time.paused then time.step() end
  if name == "v" then
    view = view % #views + 1
    physics.debug_view = views[view]
  end
end

function draw_ui()
  local stats = physics.stats()
  ui.text(("%.2f s   x%.1f%s   view: %s   %d of %d awake"):format(time.now, time.scale, time.paused and " paused" or "",
    physics.debug_view, stats.awake, stats.bodies), { at = "top_left", size = 24 })
end
