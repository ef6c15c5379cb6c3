-- A plate in the ground: while anything stands on it, its button is down and green, and its target is on.
local Plate = behaviour { target = property.node(), depth = 0.07 }       -- m

function Plate:start()
  self.visitors = 0
  self.button = self.node:get("button")
  self.rest, self.color = self.button.position, self.button.color
end

function Plate:on_trigger_enter() self:count(1) end
function Plate:on_trigger_exit() self:count(-1) end

function Plate:count(change)
  local was_on = self.visitors > 0
  self.visitors = self.visitors + change
  local on = self.visitors > 0
  if on == was_on then return end

  self.target:send("switched", on)
  sound.play("sounds/plate.ogg", { at = self.node, pitch = on and 1 or 0.8 })
  local place = on and self.rest - vec3.up * self.depth or self.rest
  tween(self.button, 0.15, { position = place, color = on and "limegreen" or self.color })
end

return Plate
