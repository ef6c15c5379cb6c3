-- Behaviours: properties, fields, life, order and messages.
local record = require "record"

local function lines() return table.concat(record.lines, ", ") end

test("start runs at the end of the tick, parents first", function()
  record.lines = {}
  scene.add { name = "p", behaviours = { witness = { label = "parent" } },
    children = { { name = "c", behaviours = { witness = { label = "child" } } } } }
  expect(lines()):equals("")
  wait(0)
  expect(lines()):equals("parent start, child start")
end)

test("main.lua comes first, then the tree; late_update comes after physics", function()
  scene.add { name = "a", behaviours = { witness = { label = "a" } }, children = { { name = "b", behaviours = { witness = { label = "b" } } } } }
  scene.add { name = "c", behaviours = { witness = { label = "c" } } }
  wait(0.1)
  record.lines = {}
  record.log_ticks = true
  wait(0)
  record.log_ticks = nil
  expect(lines()):equals("main update, a update, b update, c update, main late_update, a late_update, b late_update, c late_update")
end)

test("declared properties have their defaults, and take what is given", function()
  local plain = scene.add { behaviours = { witness = {} } }
  local given = scene.add { behaviours = { witness = { speed = 7, mood = "angry", partner = plain } } }
  wait(0)
  expect(plain.behaviours.witness.speed):equals(2.5)
  expect(plain.behaviours.witness.mood):equals("calm")
  expect(plain.behaviours.witness.partner):equals(nil)
  expect(given.behaviours.witness.speed):equals(7)
  expect(given.behaviours.witness.mood):equals("angry")
  expect(given.behaviours.witness.partner):equals(plain)
end)

test("two instances share no table", function()
  local one, two = scene.add { behaviours = { witness = {} } }, scene.add { behaviours = { witness = {} } }
  wait(0)
  one.behaviours.witness.list[1] = 99
  expect(two.behaviours.witness.list[1]):equals(1)
end)

test("wrong properties are refused by name and value", function()
  expect(function() scene.add { behaviours = { witness = { sped = 3 } } } end):raises("did you mean 'speed'?")
  expect(function() scene.add { behaviours = { witness = { speed = "fast" } } } end):raises("number expected, got \"fast\"")
  expect(function() scene.add { behaviours = { witness = { size = 4 } } } end):raises("1 to 3 expected, got 4")
  expect(function() scene.add { behaviours = { witness = { mood = "agry" } } } end):raises("did you mean 'angry'?")
  expect(function() scene.add { behaviours = { witnes = {} } } end):raises("did you mean 'witness'?")
end)

test("fields are those that start set or the table declares", function()
  local witness = scene.add { behaviours = { witness = {} } }.behaviours.witness
  wait(0)
  expect(witness.seen):equals(nil)                          -- set to nil in start
  witness.seen = "something"
  expect(witness.seen):equals("something")
  expect(function() return witness.coutn end):raises("did you mean 'count'?")
  expect(function() witness.coutn = 1 end):raises("did you mean 'count'?")
end)

test("node.behaviours gives an instance, nil, or an error where no such file is", function()
  local node = scene.add { name = "plain" }
  expect(node.behaviours.witness):equals(nil)
  expect(function() return node.behaviours.witnes end):raises("did you mean 'witness'?")
end)

test("behaviours can be added and taken away in play", function()
  record.lines = {}
  local node = scene.add { name = "plain" }
  node.behaviours.witness = { label = "late" }
  wait(0)
  expect(lines()):equals("late start")
  node.behaviours.witness = nil
  expect(lines()):equals("late start, late destroyed")
  local before = #record.lines
  wait(0.1)
  expect(#record.lines):equals(before)
end)

test("a message reaches main.lua first, then the tree, and says whether anyone listened", function()
  scene.add { name = "a", behaviours = { witness = { label = "a" } } }
  scene.add { name = "b", behaviours = { witness = { label = "b" } } }
  wait(0)
  record.lines = {}
  expect(scene.send("greet", "hello", 3)):equals(true)
  expect(lines()):equals("main hello 3, a hello 3, b hello 3")
  record.lines = {}
  expect(scene.get("b"):send("greet", "hi", 1)):equals(true)
  expect(lines()):equals("b hi 1")
  expect(scene.get("floor"):send("greet", "hi", 1)):equals(false)
end)

test("a message that nobody knows is nothing, one that is nearly known an error", function()
  expect(scene.send("something quite different")):equals(false)
  expect(function() scene.send("gret", "hi", 1) end):raises("did you mean 'greet'?")
end)

test("a slot on a node comes before its behaviours", function()
  local node = scene.add { name = "a", behaviours = { witness = { label = "a" } } }
  wait(0)
  record.lines = {}
  function node.on_greet(word, number) table.insert(record.lines, "slot " .. word) end
  node:send("greet", "hi", 1)
  expect(lines()):equals("slot hi, a hi 1")
  node.on_greet = nil
  record.lines = {}
  node:send("greet", "hi", 1)
  expect(lines()):equals("a hi 1")
end)

test("disabled, a behaviour stands still", function()
  local witness = scene.add { behaviours = { witness = {} } }.behaviours.witness
  wait(0.1)
  witness.enabled = false
  local count = witness.count
  wait(0.2)
  expect(witness.count):equals(count)
end)

test("on_destroy is told when the node goes", function()
  local node = scene.add { behaviours = { witness = { label = "it" } } }
  wait(0)
  record.lines = {}
  node:destroy()
  wait(0.1)
  expect(lines()):equals("it destroyed")
end)
