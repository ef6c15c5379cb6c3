-- Watch: press space as often as you can in five seconds. End the game and start it again: the best score is still there.
local seconds = 5
local score, left, best = 0, 0, 0

scene.add { name = "camera", position = vec3(0, 1.5, 6), camera = {} }
local ball = scene.add { name = "ball", position = vec3(0, 1, 0), mesh = "sphere", color = "tomato" }

function start()
  best = storage.load("best", 0)          -- 0 where nothing was stored yet
end

function on_press(name)
  if name ~= "space" then return end
  if left == 0 then score, left = 0, seconds end
  score = score + 1
  tween(ball, 0.05, { scale = vec3(1.3, 1.3, 1.3) }, { back = true })
end

function update(dt)
  if left == 0 then return end
  left = math.max(0, left - dt)
  if left == 0 and score > best then
    best = score
    storage.save("best", best)
  end
end

function draw_ui()
  ui.text(("%d"):format(score), { at = "top", size = 64 })
  ui.text(left > 0 and ("%.1f s"):format(left) or "press space", { at = "bottom", size = 32 })
  ui.text(("best %d"):format(best), { at = "top_right", size = 28 })
end
