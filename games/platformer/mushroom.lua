-- Throws up whoever lands on its cap.
local Mushroom = behaviour { height = 4.6 }     -- m

function Mushroom:on_trigger_enter(hit)
  if not hit.node:send("bounce", self.height) then return end
  sound.play("sounds/bounce.ogg", { at = self.node })
  tween(self.node:get("cap"), 0.12, { scale = vec3(1.25, 0.6, 1.25) }, { ease = "out", back = true })
end

return Mushroom
