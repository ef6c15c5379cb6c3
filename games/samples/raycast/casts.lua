-- Watch: a ray is thin and slips through gaps; a cast moves a whole shape and is stopped by them; an overlap asks what
-- is in a place right now. F3 (here "rays") shows every question that a script asked in the tick.
physics.debug_view = "rays"
scene.add { name = "camera", position = vec3(0, 6, 7), rotation_degrees = vec3(-42, 0, 0), camera = {} }
for i = 1, 8 do
  scene.add { name = "post " .. i, position = vec3((i - 4.5) * 0.9, 0.5, -1), color = "burlywood",
    mesh = { shape = "cylinder", radius = 0.15, height = 1 }, body = "static" }
end

local ball = { shape = "sphere", radius = 0.35 }

function update(dt)
  local x = 3 * math.sin(time.now)
  local ray = physics.raycast(vec3(x, 0.5, 3), vec3.forward, 6)
  local cast = physics.cast(ball, vec3(x, 0.5, 3), vec3.forward, 6)
  log.watch("ray", ray and ray.node.name or "free")
  log.watch("cast", cast and ("%s after %.2f m"):format(cast.node.name, cast.distance) or "free")

  local circling = vec3(3 * math.cos(time.now), 0.5, -1 + math.sin(time.now))
  for _, post in ipairs(physics.overlap({ shape = "box", size = vec3(1, 1, 1) }, circling)) do
    draw.shape({ shape = "cylinder", radius = 0.2, height = 1.1 }, post.position, post.rotation, "lime")
  end
end
