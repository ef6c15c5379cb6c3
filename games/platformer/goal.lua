-- The end of the level.
local Goal = behaviour {}

function Goal:update(dt) self.node:get("star"):turn(vec3.up, 2 * dt) end

function Goal:on_trigger_enter(hit)
  if hit.node:has_tag("player") then scene.send("goal_reached") end
end

return Goal
