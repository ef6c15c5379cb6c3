-- The five best rounds, kept from one run of the game to the next.
local most = 5

local scores = {
  list = storage.load("scores", {}),  -- { name, points } each, the best first
  latest = nil,                       -- the last round's entry, if it is one of them
}
local last_name = storage.load("name", "You")

local function save()
  storage.save("scores", scores.list)
  storage.save("name", last_name)
end

function scores.add(points)
  local list, place = scores.list, 1
  while list[place] and list[place].points >= points do place = place + 1 end
  scores.latest = nil
  if points == 0 or place > most then return end
  scores.latest = { name = last_name, points = points }
  table.insert(list, place, scores.latest)
  list[most + 1] = nil
  save()
end

function scores.rename(entry, name)
  if entry.name == name then return end
  entry.name, last_name = name, name
  save()
end

return scores
