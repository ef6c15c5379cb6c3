-- A ball on a floor, in a wind that the host program makes.
scene.add { name = "floor", position = vec3(0, -0.5, 0), mesh = { shape = "box", size = vec3(50, 1, 50) }, body = "static" }
local ball = scene.add { name = "ball", position = vec3(0, 10, 0), mesh = "sphere", body = { mass = 2 }, behaviours = { ball = {} } }

function update()
  ball.body:apply_force(vec3(host.wind(ball.position.y), 0, 0))
end

function on_press(name)
  if name == "space" then ball.body:apply_impulse(0, 20, 0) end
end

function on_greet(text, place)
  game.report.greeting = text .. " from " .. tostring(place)
end

function on_ask()
  local ok, message = pcall(host.refuse)
  game.report.refused = not ok and message
  ball.body.mass = -1          -- an error of Tumble's Lua, in a call that comes from the host
end
