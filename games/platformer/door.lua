-- The leaf of a gate on its hinge: a motor opens or shuts it when a lever or a plate says so.
local Door = behaviour { leaf = "leaf", open_degrees = 85 }

function Door:start() self.hinge = self.node:get(self.leaf):joint("hinge") end
function Door:on_open() self.hinge.motor.target_degrees = self.open_degrees end
function Door:on_close() self.hinge.motor.target_degrees = 0 end

return Door
