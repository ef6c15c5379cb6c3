-- What levers, plates, crates, planks and platforms do when the player comes.
local function begin(level)
  wait(0.2)
  click("Play")
  wait(0.2)
  if level then scene.load(level) end
  wait(1)                                 -- what hangs and tips comes to rest
  local player = scene.get("player")
  return player, player.behaviours.character
end

-- To a standing place `top` metres above a node's middle, `aside` from there.
local function put_on(player, path, top, aside)
  player:teleport(scene.get(path).world_position + vec3.up * (top + 0.9) + (aside or vec3.zero))
  player.behaviours.character:stop()
  wait(0.2)
end

local function gate_degrees() return scene.get("gate/leaf"):joint("hinge").angle_degrees end

test("pulling the lever opens the gate, pulling it again shuts it", function()
  local player = begin()
  put_on(player, "lever", 0, vec3(0, 0, 1))
  expect(gate_degrees()):near(0, 1)
  tap("use", 0.05)
  wait(2)
  expect(gate_degrees()):near(85, 2)
  tap("use", 0.05)
  wait(2)
  expect(gate_degrees()):near(0, 2)
end)

test("from afar the lever does nothing", function()
  begin()
  tap("use", 0.05)
  wait(2)
  expect(gate_degrees()):near(0, 1)
end)

test("a shut gate is not pushed open", function()
  local player = begin()
  local gate = scene.get("gate")
  player:teleport(gate.world_position + vec3(-1.5, 0.9, 0))
  player.behaviours.player.enabled = false
  for _ = 1, 120 do
    player.behaviours.character:move(vec3.right * 6)
    wait(0)
  end
  expect(gate_degrees()):below(3)
  expect(player.position.x):below(gate.world_position.x)
end)

test("the plate holds the gate open as long as the crate stands on it", function()
  begin("levels/two")
  local plate, crate = scene.get("plate"), scene.get("crate")
  local home = crate.world_position
  expect(gate_degrees()):near(0, 1)
  crate:teleport(plate.world_position + vec3.up * 0.6)
  wait(3)
  expect(gate_degrees()):near(85, 2)
  crate:teleport(home)
  wait(3)
  expect(gate_degrees()):near(0, 2)
end)

test("a crate is pushed by walking against it", function()
  local player = begin()
  local crate = scene.get("crate")
  local from = crate.world_position
  player:teleport(from + vec3(0, 0.4, 1.2))
  player.behaviours.character:stop()
  press("forward")
  wait(1)
  release("forward")
  expect(crate.world_position.z):below(from.z - 0.7)
  expect(crate.world_position.x):near(from.x, 0.2)
end)

test("a crate that fell off its island comes back", function()
  begin()
  local crate = scene.get("crate")
  local home = crate.world_position
  crate:teleport(vec3(40, 0, 40))
  wait(4)
  expect(crate.world_position):near(home, 0.1)
end)

test("the seesaw tips to the side on which the player stands", function()
  local player = begin("levels/two")
  local hinge = scene.get("seesaw/plank"):joint("hinge")
  put_on(player, "seesaw/plank", 0.5, vec3(0, 0, 2.5))
  wait(1.5)
  local near_side = hinge.angle_degrees
  put_on(player, "seesaw/plank", 0.9, vec3(0, 0, -2.5))
  wait(1.5)
  expect(math.abs(near_side)):near(12, 0.5)
  expect(hinge.angle_degrees):near(-near_side, 0.5)
end)

test("the bridge holds the player, and sags under the weight", function()
  local player, character = begin()
  local middle = scene.get("bridge/plank 5")
  local height = middle.world_position.y
  put_on(player, "bridge/plank 5", 0.06)
  local lowest = height
  for _ = 1, 60 * 10 do
    wait(0)
    lowest = math.min(lowest, middle.world_position.y)
  end
  expect(character.is_grounded):equals(true)
  expect(lowest):below(height - 0.005)
  expect(lowest):above(height - 0.5)
  for i = 1, 10 do
    for _, joint in ipairs(scene.get("bridge/plank " .. i):joints()) do expect(joint.is_broken):equals(false) end
  end
end)

test("the bridge can be walked from end to end", function()
  local player, character = begin()
  local bridge = scene.get("bridge")
  player:teleport(bridge.world_position + vec3(-5, 0.9, 0))
  player.behaviours.player.enabled = false
  local lowest = 0
  wait_until(function()
    character:move(vec3.right * 6)
    lowest = math.min(lowest, player.position.y - bridge.world_position.y - 0.85)
    return player.position.x > bridge.world_position.x + 5
  end, 4)
  expect(player.position.x):above(bridge.world_position.x + 5)
  expect(lowest):above(-1.2)
end)

test("the ferry carries a standing player across", function()
  local player, character = begin()
  local ferry = scene.get("ferry")
  put_on(player, "ferry", 0.15)
  local foothold = ferry:to_local(player.position)
  local from, far = ferry.position, 0
  for _ = 1, 60 * 12 do
    wait(0)
    far = math.max(far, ferry.position:distance(from))
    expect(ferry:to_local(player.position)):near(foothold, 0.01)
  end
  expect(far):above(6)
  expect(character.is_grounded):equals(true)
end)

test("the wheel carries a standing player round, and turns the figure with it", function()
  local player = begin()
  local wheel, figure = scene.get("wheel 1"), scene.get("player/figure")
  put_on(player, "wheel 1", 0.15, vec3(1, 0, 0))
  wait(0.3)
  local foothold, ahead = wheel:to_local(player.position), wheel.world_rotation:inverse() * figure.forward
  wait(3)
  expect(wheel:to_local(player.position)):near(foothold, 0.01)
  expect(wheel.world_rotation:inverse() * figure.forward):near(ahead, 0.01)
end)

test("a mushroom throws up to its height, and letting go of jump does not end it", function()
  local player, character = begin()
  local mushroom = scene.get("mushroom")
  put_on(player, "mushroom", 2)
  local top = 0
  tap("jump", 0.05)
  wait_until(function()
    top = math.max(top, player.position.y)
    return character.climb < 0 and top > mushroom.world_position.y + 3
  end, 3)
  expect(top - mushroom.world_position.y - 1 - 0.85):near(mushroom.behaviours.mushroom.height, 0.4)   -- its trigger begins above the cap
end)

test("the sweeper's arm hurts, and can be jumped over", function()
  local player, character = begin("levels/two")
  local arm = scene.get("sweeper/arm")
  put_on(player, "sweeper", 0, vec3(2.5, 0, 0))
  wait_until(function() return game.report.falls == 1 end, 5)
  expect(game.report.falls):equals(1)
  local place = scene.get("sweeper").world_position + vec3(2.5, 0, 0)
  wait_until(function() return math.abs(arm:to_local(place).z) > 2.4 end, 5)
  put_on(player, "sweeper", 0, vec3(2.5, 0, 0))
  local hops = 0
  for _ = 1, 60 * 10 do
    local near = arm:to_local(player.position):with_y(0)
    if math.abs(near.z) < 0.8 and character.is_grounded then
      hops = hops + 1
      tap("jump", 0.4)
    end
    wait(0)
  end
  expect(hops):above(1)
  expect(game.report.falls):equals(1)
end)
