-- A gate whose leaf turns on a hinge: the hinge's motor opens or shuts it when a lever or a plate says so.
local Gate = behaviour { open_degrees = 85 }

function Gate:start() self.hinge = self.node:get("leaf"):joint("hinge") end

function Gate:on_switched(on)
  self.hinge.motor.target_degrees = on and self.open_degrees or 0
  sound.play("sounds/door.ogg", { at = self.node })
end

return Gate
