-- A plate in the ground: while anything stands on it, its target is open.
local Plate = behaviour { target = property.node() }

function Plate:start()
  self.load = 0         -- how many bodies stand on it
  self.button = self.node:get("button")
  self.rest = self.button.position
end

function Plate:on_trigger_enter() self:change(1) end
function Plate:on_trigger_exit() self:change(-1) end

function Plate:change(by)
  self.load = self.load + by
  local is_down = self.load > 0
  self.target:send(is_down and "open" or "close")
  tween(self.button, 0.15, { position = self.rest - vec3.up * (is_down and 0.07 or 0), color = is_down and "limegreen" or "#e0533d" })
end

return Plate
