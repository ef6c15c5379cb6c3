-- A mark on the floor, from which balls are thrown. The one in use glows.
local Spot = behaviour { points = 2 }    -- of a basket from here

function Spot:hand_height() return self.node.world_position:with_y(1.5) end

function Spot:light_up(on) self.node.material.glow = on and 1 or 0 end

return Spot
