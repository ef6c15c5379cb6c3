-- Plays the levels to the end: walks from stop to stop, jumps where the ground ends or something is in the way, waits for
-- platforms, pushes crates, pulls levers. It looks at the world as a player does and knows no numbers of the physics.
local player, character

local function is_over() return game.report.screen ~= "playing" end

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
  return physics.raycast_any(player.world_position + direction * metres, vec3.down, 1.7, { ignore = player })
end

local function danger_near(direction)
  local feet = player.world_position - vec3.up * 0.4 + direction * 0.5
  return #physics.overlap({ shape = "sphere", radius = 1 }, feet, { ignore = player, tags = "hazard", triggers = true }) > 0
end

-- A wall higher than a step and lower than a jump?
local function ledge_ahead(direction)
  local foot = player.world_position - vec3.up * 0.4
  return physics.raycast_any(foot, direction, 0.8, { ignore = player })
    and not physics.raycast_any(foot + vec3.up * 0.9, direction, 1, { ignore = player })
end

-- One tick on the way to `place`; true once it is there.
local function approach(place, near)
  local way = place - player.world_position
  local flat = way:with_y(0)
  if flat:length() < near and math.abs(way.y) < 1.6 and character.is_grounded then
    steer(vec3.zero)
    return true
  end
  local direction = flat:normalized()
  steer(flat:clamped(1))
  local is_far = flat:length() > 0.8
  if is_far and (not ground_ahead(direction, 0.7) or danger_near(direction) or ledge_ahead(direction)) then hop() end
  return false
end

local function walk_to(name, near)
  return function()
    local target = scene.find(name)                      -- a coin is gone once it was taken
    if not target then return true end
    return wait_until(function()
      return not target.is_alive or is_over() or approach(target.world_position, near or 0.4)
    end, 12)
  end
end

-- Goes behind the crate and walks against it until it is at the other thing, or cannot be pushed farther.
local function push(name, to)
  return function()
    local crate, target = scene.get(name), scene.get(to)
    local function way() return (target.world_position - crate.world_position):with_y(0) end
    local function behind(metres) return crate.world_position - way():normalized() * metres end
    if not wait_until(function() return approach(behind(1.3), 0.3) end, 12) then return false end

    local last, rests = crate.world_position, 0
    return wait_until(function()
      steer(((behind(0.3) - player.world_position):with_y(0) * 2):clamped(1))
      local moved = crate.world_position:distance(last)
      rests = moved < 0.004 and rests + 1 or 0
      last = crate.world_position
      return way():length() < 0.5 or rests > 40
    end, 15)
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
      return rests and gap:with_y(0):length() < 7 and math.abs(gap.y) < 1.3
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

-- The seats of a carousel, `radius` metres from its middle: the one nearest to a place.
local function nearest_seat(carousel, radius, place)
  local best
  for _, way in ipairs { vec3.left, vec3.right, vec3.forward, vec3.back } do
    local seat = carousel:to_world(way * radius)
    if not best or seat:distance(place) < best:distance(place) then best = seat end
  end
  return best
end

-- Waits for a seat to come by and steps on to it.
local function seat(name, radius)
  return function()
    local carousel = scene.get(name)
    local function gap() return (nearest_seat(carousel, radius, player.world_position) - player.world_position):with_y(0):length() end
    local ahead = (carousel.world_position - player.world_position):with_y(0):normalized()
    wait_until(function()
      steer(ahead)
      return not ground_ahead(ahead, 0.9)
    end, 5)
    steer(vec3.zero)
    return wait_until(function() return gap() < 2.6 end, 20)
      and wait_until(function() return approach(nearest_seat(carousel, radius, player.world_position), 0.4) end, 3)
  end
end

-- Stays on its seat until it is as near to a place as it gets.
local function dwell(name, to, radius)
  return function()
    local carousel, goal = scene.get(name), scene.get(to)
    return wait_until(function()
      local mine = nearest_seat(carousel, radius, player.world_position)
      approach(mine, 0.3)
      return mine:distance(nearest_seat(carousel, radius, goal.world_position)) < 0.1
        and (goal.world_position - mine):normalized():dot((mine - carousel.world_position):normalized()) > 0.98
    end, 30)
  end
end

local function use()
  steer(vec3.zero)
  wait(0.1)
  tap("use", 0.1)
  wait(1.5)
  return true
end

-- Jumps on to a mushroom and steers to the place where it throws.
local function bounce(name, to)
  return function()
    local cap, goal = scene.get(name .. "/cap"), scene.get(to)
    local low = player.world_position.y
    local up = wait_until(function()
      steer((cap.world_position - player.world_position):with_y(0):clamped(1))
      if cap.world_position:distance(player.world_position) < 2.2 then hop() end
      return player.world_position.y > low + 2.5
    end, 6)
    return up and wait_until(function()
      steer((goal.world_position - player.world_position):with_y(0):clamped(1))
      return character.is_grounded
    end, 4)
  end
end

-- A fall leads back to the first stop of the section.
local levels = {
  {
    { walk_to "coin 1", walk_to "coin 2", walk_to "start", walk_to("stone 1", 0.3), walk_to("stone 2", 0.3) },
    { push("crate", "cliff"), walk_to("checkpoint 1", 0.6) },
    { board "ferry", ride "ferry", walk_to "green", walk_to("lever", 1), use, walk_to "coin 8", walk_to "green", walk_to "neck",
      walk_to "bridge", walk_to "glade" },
    { bounce("mushroom", "terrace"), walk_to("checkpoint 2", 0.6) },
    { walk_to "coin 14", walk_to "terrace", walk_to("wheel 1", 0.3), walk_to("wheel 2", 0.3), walk_to "coin 18", walk_to "coin 17",
      walk_to("goal", 0.2) },
  },
  {
    { walk_to "coin 1", walk_to "coin 2", walk_to("start", 1), walk_to("seesaw/plank", 0.5), walk_to("mill", 4), walk_to "coin 5",
      walk_to "coin 6", walk_to("stone 1", 0.3), walk_to("checkpoint 1", 0.6) },
    { push("crate", "plate"), walk_to "court", walk_to "coin 8", walk_to "court", walk_to "neck", walk_to "landing" },
    { board "lift", ride "lift", walk_to("checkpoint 2", 0.6) },
    { walk_to "coin 11", walk_to "balcony", seat("carousel", 4.4), dwell("carousel", "perch", 4.4), walk_to("checkpoint 3", 0.6) },
    { walk_to "coin 13", walk_to "perch", walk_to "bridge", walk_to "grove", bounce("mushroom 1", "ledge"),
      bounce("mushroom 2", "summit"), walk_to "coin 19", walk_to "coin 20", walk_to "summit", walk_to("goal", 0.2) },
  },
}

local function falls() return game.report.falls or 0 end

local function play(section)
  local before = falls()
  for _, stop in ipairs(section) do
    if not stop() or falls() > before then return false end
  end
  return true
end

local function play_level(sections)
  player = scene.get("player")
  character = player.behaviours.character
  for _, section in ipairs(sections) do
    for _ = 1, 5 do
      if play(section) or is_over() then break end
    end
  end
  steer(vec3.zero)
end

return function()
  for number, sections in ipairs(levels) do
    wait(1)
    click(number == 1 and "Play" or "Next level")
    wait(0.5)
    play_level(sections)
  end
end
