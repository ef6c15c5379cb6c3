-- What the level promises to whoever plays it.
local function begin()
  wait(0.2)
  click("Play")
  wait(0.3)
  local player = scene.get("player")
  return player, player.behaviours.character, player.behaviours.player
end

-- To a standing place on top of a node's middle.
local function put_on(player, name, top)
  player:teleport(scene.get(name).world_position + vec3.up * (top + 0.9))
  player.behaviours.character:stop()
  wait(0.2)
end

test("nothing happens before it is started, and without input it is not finished", function()
  wait(20)
  expect(game.is_finished):equals(false)
  expect(game.report.score):equals(0)
  expect(game.report.seconds):equals(0)
end)

test("started and left alone, it is not finished either", function()
  begin()
  wait(30)
  expect(game.is_finished):equals(false)
  expect(game.report.score):equals(0)
  expect(game.report.falls):equals(0)
end)

for _, level in ipairs { "levels/one", "levels/two" } do
  test(level .. " has coins, checkpoints, hazards, a gem and one goal", function()
    scene.load(level)
    wait(0.2)
    expect(#scene.tagged("coin")):above(14)
    expect(#scene.tagged("checkpoint")):above(1)
    expect(#scene.tagged("hazard")):above(0)
    expect(#scene.tagged("goal")):equals(1)
    expect(scene.find("gem 1")):equals(scene.get("gem 1"))
  end)
end

test("a coin is counted once and gone", function()
  local player = begin()
  local coin = scene.get("coin 1")
  local score = game.report.score
  player:teleport(coin.world_position)
  wait(0.5)
  expect(coin.is_alive):equals(false)
  expect(game.report.coins):equals(1)
  expect(game.report.score):above(score)
end)

test("who falls comes back to the start", function()
  local player, _, steering = begin()
  player:teleport(vec3(60, 0, 30))
  wait_until(function() return game.report.falls == 1 end, 5)
  wait(1)
  expect(player.position):near(steering.home, 0.2)
end)

test("after a checkpoint, who falls comes back to it", function()
  local player = begin()
  local checkpoint = scene.get("checkpoint 1")
  player:teleport(checkpoint.world_position + vec3.up)
  wait(0.5)
  player:teleport(vec3(60, 0, 30))
  wait_until(function() return game.report.falls == 1 end, 5)
  wait(1)
  expect(player.position:with_y(0)):near(checkpoint.world_position:with_y(0), 0.2)
  expect(player.behaviours.character.is_grounded):equals(true)
end)

test("spikes hurt", function()
  local player, _, steering = begin()
  put_on(player, "spikes 1", 0.1)
  wait(0.5)
  expect(game.report.falls):equals(1)
  expect(player.position):near(steering.home, 0.2)
end)

-- Into the goal of the level that is played.
local function reach_the_goal()
  scene.get("player"):teleport(scene.get("goal").world_position + vec3.up)
  wait(0.3)
end

test("the goal leads to the next level, and the last one finishes the game", function()
  begin()
  reach_the_goal()
  expect(game.is_finished):equals(false)
  expect(game.report.screen):equals("won")
  click("Next level")
  wait(0.5)
  expect(scene.name):equals("levels/two")
  expect(game.report.screen):equals("playing")
  reach_the_goal()
  expect(game.is_finished):equals(true)
end)

test("who is quick gets points for it, once", function()
  begin()
  wait(1)
  local seconds = game.report.seconds
  reach_the_goal()
  expect(game.report.score):near((120 - seconds) * 5, 5)
  local score = game.report.score
  wait(2)
  expect(game.report.score):equals(score)
end)
