-- Watch: the moon circles the earth, and both circle the sun, though each line turns only one node.
-- A child's position is relative to its parent, so whoever turns or moves takes its children along.
scene.add { name = "camera", position = vec3(0, 6, 9), rotation_degrees = vec3(-33, 0, 0), camera = {} }

local sun = scene.add { name = "sun", mesh = { shape = "sphere", radius = 1 }, material = { color = "gold", glow = 1 } }
local year = scene.add { name = "year", parent = sun }          -- a node without a look: a hub that turns
local earth = scene.add { name = "earth", parent = year, position = vec3(4, 0, 0), color = "dodgerblue",
  mesh = { shape = "sphere", radius = 0.45 } }
local moon = scene.add { name = "moon", parent = earth, position = vec3(1, 0, 0), color = "lightgray",
  mesh = { shape = "sphere", radius = 0.15 } }

function update(dt)
  year:turn(vec3.up, 0.5 * dt)                                  -- radians per second, times the tick's length
  earth:turn(vec3.up, 3 * dt)
  draw.line(earth.world_position, moon.world_position, "gray")
  draw.text(moon.world_position, ("moon: here %.1f m, in the world %.1f m"):format(moon.position.x, moon.world_position.x))
end
