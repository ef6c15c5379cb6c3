-- Its disc turns until the player touches it, then counts and is gone.
local Pickup = behaviour { value = 1, turn_speed = 3 }      -- coins; rad/s

function Pickup:update(dt) self.node:get("disc"):turn(vec3.up, self.turn_speed * dt) end

function Pickup:on_trigger_enter(hit)
  if not hit.node:has_tag("player") then return end
  scene.send("pickup", self.value)
  self.node:destroy()
end

return Pickup
