-- A game full of mistakes, for tests/cli/run.sh: expected.txt says which line each stands in.
local helper = require "helper"
local score = 0
local leftover = 3

local ball = scene.add { name = "ball", mesh = "sphere", body = { mass = 1 } }

function start()
  score = scroe + helper.points
  hihgscore = 10
  scene.add { name = "crate", positon = vec3(0, 1, 0), mesh = "box" }
  scene.add { name = "coin", mesh = "sphere", color = "oragne" }
  scene.add { name = "wall", mesh = "box", material = { texture = "textures/wod.png" } }
  scene.add { name = "slime", behaviours = { enmy = {} } }
  scene.add { name = "hero", mesh = "box", body = { group = "plyer" } }
end

function Update(dt)
  if input.was_pressed("jmup") then sound.play("sounds/jmp.ogg") end
  if physics.raycst(vec3.zero, vec3.down, 2) then scene.send("scored_point", score) end
  if ball.body.velocty:length() > 3 then ball:aply_impulse(vec3.up) end
  if ball.postion.y < 0 then scene.load("levels/tow") end
  for _, coin in ipairs(scene.tagged("coinn")) do print(coin.position:lenght(), dt) end
end

function on_scored_points(points) score = score + points end

function on_press(name)
  if name == "paus" then time.paused = true end
  if name == "go" then scene.load("levels/two") end
end
