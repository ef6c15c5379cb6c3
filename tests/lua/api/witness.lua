-- A behaviour that writes down its life.
local record = require "record"
local Witness = behaviour { label = "?", speed = 2.5, mood = property.choice { "calm", "angry" }, partner = property.node(),
  size = property.number { 2, min = 1, max = 3 }, list = { 1, 2, 3 } }

function Witness:note(text) table.insert(record.lines, self.label .. " " .. text) end

function Witness:start()
  self.seen = nil                     -- a field may hold nil once it was set
  self.count = 0
  self:note("start")
end

function Witness:update(dt)
  self.count = self.count + 1
  if record.log_ticks then self:note("update") end
end

function Witness:late_update(dt)
  if record.log_ticks then self:note("late_update") end
end

function Witness:on_greet(word, number) self:note(("%s %d"):format(word, number)) end
function Witness:on_beat(seconds) task.every(seconds, self.note, self, "beat") end
function Witness:on_destroy() self:note("destroyed") end
function Witness:on_collision_enter(hit) self:note("meets " .. hit.node.name) end

return Witness
