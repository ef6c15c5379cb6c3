-- Keys pressed without sense, from every checkpoint on: the player falls, but never through anything, and is never stuck.
local KEYS = { "forward", "back", "left", "right", "jump", "use" }

local function press_anything()
  for _, key in ipairs(KEYS) do
    if random.chance(0.4) then press(key) else release(key) end
  end
end

-- How deep the player is in anything that stands still, m.
local function depth(player, character)
  local deepest = 0
  for _, hit in ipairs(physics.penetrations(character.shape, player.world_position, 0, { ignore = player })) do
    if hit.body.type == "static" then deepest = math.max(deepest, -hit.distance) end
  end
  return deepest
end

local function play_from(place)
  local player = scene.get("player")
  local character, steering = player.behaviours.character, player.behaviours.player
  player:teleport(place)
  character:stop()
  steering.home = place
  local hangs, last, falls = 0, place, game.report.falls
  for i = 1, 60 * 8 do
    if i % 24 == 1 then press_anything() end
    wait(0)
    local here = player.world_position
    expect(depth(player, character)):below(0.1)                             -- m, squeezed by what moves
    expect(here.y):above(steering.home.y - steering.fall_depth - 1)
    hangs = not character.is_grounded and here:distance(last) < 1e-4 and hangs + 1 or 0
    expect(hangs):below(10)
    -- In a tick it walks 0.1 m, and a platform or something that pushes it aside adds to that.
    if game.report.falls == falls then expect((here - last):with_y(0):length()):below(0.25) end
    last, falls = here, game.report.falls
    if game.report.screen ~= "playing" then return end
  end
end

for number, level in ipairs { "levels/one", "levels/two" } do
  test("crooked play in " .. level, function()
    wait(0.2)
    click("Play")
    wait(0.2)
    if number > 1 then scene.load(level) end
    wait(0.5)
    local places = { scene.get("player").world_position }
    for _, checkpoint in ipairs(scene.tagged("checkpoint")) do table.insert(places, checkpoint.world_position + vec3.up) end
    for _, place in ipairs(places) do play_from(place) end
  end)
end
