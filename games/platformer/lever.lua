-- Stand near it and press "use": tells its target to open, the next time to close.
local Lever = behaviour { target = property.node() }

function Lever:start() self.is_near, self.is_pulled = false, false end

function Lever:on_trigger_enter(hit) if hit.node:has_tag("player") then self.is_near = true end end
function Lever:on_trigger_exit(hit) if hit.node:has_tag("player") then self.is_near = false end end

function Lever:update()
  if self.is_near and input.was_pressed("use") then self:pull() end
end

function Lever:pull()
  self.is_pulled = not self.is_pulled
  self.target:send(self.is_pulled and "open" or "close")
  tween(self.node:get("handle"), 0.3, { rotation_degrees = vec3(0, 0, self.is_pulled and -35 or 35) }, { ease = "out_back" })
end

return Lever
