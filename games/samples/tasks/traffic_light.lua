-- Watch: a task is a function that can wait, so a light's whole day is written from top to bottom. Tweens change
-- a value little by little: the cart drives off and brakes without any code in update().
scene.add { name = "camera", position = vec3(0, 2, 7), rotation_degrees = vec3(-6, 0, 0), camera = {} }
scene.add { name = "road", position = vec3(0, -0.05, 0), color = "dimgray", mesh = { shape = "box", size = vec3(12, 0.1, 3) } }
scene.add { name = "box", position = vec3(0, 1, -1.8), color = "black", mesh = { shape = "box", size = vec3(0.6, 2, 0.3) } }

local lamps = {}
for i, name in ipairs { "red", "yellow", "lime" } do
  lamps[name] = scene.add { name = name, position = vec3(0, 2.2 - i * 0.6, -1.65), color = "dimgray",
    mesh = { shape = "sphere", radius = 0.2 } }
end
local cart = scene.add { name = "cart", position = vec3(-4, 0.3, 0), color = "tomato",
  mesh = { shape = "box", size = vec3(1, 0.6, 0.7) } }

local function show(name)
  for _, lamp in pairs(lamps) do tween(lamp, 0.15, { color = "dimgray" }) end
  tween(lamps[name], 0.15, { color = name })                -- a new tween of a colour takes over from the old one
end

local function one_round()
  show("red")
  tween(cart, 1.2, { position = vec3(-1, 0.3, 0) }, { ease = "out" }):wait()
  wait(0.8)
  show("yellow")
  wait(0.5)
  show("lime")
  tween(cart, 1.5, { position = vec3(7, 0.3, 0) }, { ease = "in" }):wait()
  cart:teleport(-7, 0.3, 0)
end

function start() task.loop(one_round) end                   -- again and again, with the newest text each round
