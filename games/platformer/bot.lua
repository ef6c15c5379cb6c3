-- Plays the level to its end: walks from stop to stop, jumps where the ground ends or something is in the way, waits for
-- platforms. It looks at the world as a player does and knows no numbers of the physics.
local player, character

local function steer(way)
  local view = scene.camera
  set_axis("left", "right", way:dot(view.right))
  set_axis("back", "forward", way:dot(view.forward:with_y(0):normalized()))
end

local function hop()
  if character.is_grounded then tap("jump", 0.4) end
end

-- Is there ground `metres` ahead, not much lower than the feet?
local function ground_ahead(direction, metres)
  return physics.raycast_any(player.world_position + direction * metres, vec3.down, 1.6, { ignore = player })
end

local function danger_ahead(direction)
  local hit = physics.raycast(player.world_position - vec3.up * 0.6, direction, 1.2, { ignore = player, tags = "hazard", triggers = true })
  return hit ~= nil
end

-- One tick on the way to `place`; true once it is there.
local function approach(place, near)
  local way = place - player.world_position
  local flat = way:with_y(0)
  if flat:length() < near and math.abs(way.y) < 1.5 and character.is_grounded then
    steer(vec3.zero)
    return true
  end
  local direction = flat:normalized()
  steer(flat:clamped(1))
  local is_far = flat:length() > 0.8
  if is_far and (not ground_ahead(direction, 0.7) or danger_ahead(direction)) then hop() end
  return false
end

local function walk_to(name, near)
  return function()
    local target = scene.find(name)                      -- a coin is gone once it was taken
    if not target then return true end
    return wait_until(function() return not target.is_alive or approach(target.world_position, near or 0.4) end, 12)
  end
end

-- Waits until the platform is near and rests, then steps on to its middle.
local function board(name)
  return function()
    local platform = scene.get(name)
    local last = vec3.zero
    local came = wait_until(function()
      local here = platform.world_position
      local rests = here == last
      last = here
      local gap = here - player.world_position
      return rests and gap:with_y(0):length() < 5 and math.abs(gap.y) < 1.3
    end, 20)
    return came and wait_until(function() return approach(platform.world_position, 0.4) end, 3)
  end
end

-- Stands still on the platform until it rests somewhere else.
local function ride(name)
  return function()
    local platform = scene.get(name)
    local from = platform.world_position
    local last = from
    steer(vec3.zero)
    return wait_until(function()
      local here = platform.world_position
      local rests = here == last
      last = here
      return rests and here:distance(from) > 1
    end, 15)
  end
end

-- A fall leads back to the first stop of the section.
local sections = {
  { walk_to "coin 1", walk_to "start", walk_to "coin 3", walk_to "meadow", walk_to "coin 4", walk_to "step 1",
    walk_to("checkpoint 1", 0.6) },
  { walk_to "coin 5", walk_to "lookout", board "ferry", ride "ferry", walk_to "forest", walk_to("stone 1", 0.3),
    walk_to("wheel", 0.3), walk_to("stone 2", 0.3), walk_to("checkpoint 2", 0.6) },
  { walk_to "coin 10", walk_to "fort", walk_to("pier", 0.3), board "lift", ride "lift", walk_to "height",
    walk_to("beam", 0.3), walk_to "summit", walk_to("goal", 0.2) },
}

local function falls() return game.report.falls or 0 end

local function play(section)
  local before = falls()
  for _, stop in ipairs(section) do
    if not stop() or falls() > before then return false end
  end
  return true
end

return function()
  wait(1)
  tap("start", 0.1)
  wait(0.3)
  player = scene.get("player")
  character = player.behaviours.character
  for _, section in ipairs(sections) do
    for _ = 1, 5 do
      if play(section) or game.is_finished then break end
    end
  end
  steer(vec3.zero)
end
