-- Watch: space makes the ball hop. Press r and then another key, button or stick: from now on that one does, and in the next
-- run too. Escape keeps the key as it is; backspace brings back the one of game.json.
local asking = false

scene.add { name = "camera", position = vec3(0, 1.5, 6), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), mesh = { shape = "box", size = vec3(8, 0.2, 4) }, color = "gray", body = "static" }
local ball = scene.add { name = "ball", position = vec3(0, 0.5, 0), mesh = "sphere", color = "orange", body = { restitution = 0.4 } }

local function take(name)
  asking = false
  if name then input.bind("hop", { name }, { save = true }) end   -- nil: it was escape
end

function on_press(name)
  if name == "hop" then
    ball.body:apply_impulse(vec3(0, 4, 0))
    input.rumble(0.4, 0.1)
  elseif name == "r" then
    asking = true
    input.listen(take)
  elseif name == "backspace" then
    input.reset_bindings("hop")
  end
end

function draw_ui()
  local keys = {}
  for i, name in ipairs(input.bindings("hop")) do keys[i] = input.describe(name) end
  ui.text(asking and "press what shall make it hop" or "hop: " .. table.concat(keys, " or "), { at = "top", size = 36 })
end
