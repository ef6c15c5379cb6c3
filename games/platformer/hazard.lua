-- Hurts whoever touches it.
local Hazard = behaviour {}

function Hazard:on_trigger_enter(hit)
  if hit.node:has_tag("player") then hit.node:send("hurt") end
end

return Hazard
