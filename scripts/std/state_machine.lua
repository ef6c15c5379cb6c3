-- One state at a time: what a game or a creature is doing, and what happens when that changes.
--
--   local state_machine = require "state_machine"
--
--   local states = { title = {}, playing = {}, over = {} }
--   function states.playing.enter() score = 0 end
--   function states.playing.update(dt) seconds = seconds - dt end
--   function states.playing.exit() storage.save("score", score) end
--
--   local state = state_machine(states, "title")
--   function update(dt) state:update(dt) end
--   function on_press(name) if name == "start" then state:go("playing") end end
--
-- A state may have enter(...), update(dt) and exit(); in a behaviour call them with self: state:update(dt, self).
-- go(name, ...)   leaves the state and enters that one, with the arguments for enter; the same one too
-- is(name)        is it in that state?
-- Read: name, and seconds since it was entered, as update counts them. The first state is entered by the first update.
local StateMachine = {}
StateMachine.__index = StateMachine

local function check(machine, name, call)
  if machine.states[name] then return end
  local names = {}
  for known in pairs(machine.states) do names[#names + 1] = known end
  error(("state_machine: %s: there is no state '%s'; it has %s"):format(call, tostring(name), table.concat(names, ", ")), 3)
end

function StateMachine:go(name, ...)
  check(self, name, "go")
  local before = self.entered and self.states[self.name]
  if before and before.exit then before.exit() end
  self.name, self.seconds, self.entered = name, 0, true
  local now = self.states[name]
  if now.enter then now.enter(...) end
end

function StateMachine:update(dt, ...)
  if not self.entered then self:go(self.name, ...) end
  self.seconds = self.seconds + dt
  local now = self.states[self.name]
  if now.update then now.update(dt, ...) end
end

function StateMachine:is(name)
  check(self, name, "is")
  return self.name == name
end

return function(states, first)
  local machine = setmetatable({ states = states, name = first, seconds = 0, entered = false }, StateMachine)
  check(machine, first, "the first state")
  return machine
end
