-- scripts/std/state_machine.
local state_machine = require "state_machine"

local function recorded()
  local lines = {}
  local states = { title = {}, playing = {}, over = {} }
  for name, state in pairs(states) do
    state.enter = function(word) lines[#lines + 1] = "enter " .. name .. (word and " " .. word or "") end
    state.update = function(dt) lines[#lines + 1] = "update " .. name end
    state.exit = function() lines[#lines + 1] = "exit " .. name end
  end
  states.over.update = nil
  return states, lines
end

test("the first update enters the first state, go leaves it and enters the next", function()
  local states, lines = recorded()
  local machine = state_machine(states, "title")
  expect(#lines):equals(0)
  machine:update(0.1)
  machine:go("playing", "quickly")
  machine:update(0.1)
  machine:go("over")
  machine:update(0.1)
  expect(table.concat(lines, ", ")):equals("enter title, update title, exit title, enter playing quickly, update playing, exit playing, enter over")
end)

test("it knows its state and how long it has been in it", function()
  local machine = state_machine(recorded(), "title")
  for _ = 1, 5 do machine:update(0.5) end
  expect(machine.seconds):equals(2.5)
  expect(machine:is("title")):equals(true)
  machine:go("title")
  expect(machine.seconds):equals(0)
end)

test("a state that is not there is named, with those that are", function()
  local machine = state_machine(recorded(), "title")
  expect(function() machine:go("titel") end):raises("state_machine: go: there is no state 'titel'; it has over, playing, title")
  expect(function() state_machine({ a = {} }, "b") end):raises("the first state: there is no state 'b'; it has a")
end)
