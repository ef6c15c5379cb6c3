-- The end of the level, under a star that turns.
local Goal = behaviour { turn_speed = 2 }       -- rad/s

function Goal:start() self.star = self.node:get("star") end

function Goal:update(dt) self.star:turn(vec3.up, self.turn_speed * dt) end

function Goal:on_trigger_enter(hit)
  if not hit.node:has_tag("player") then return end
  if not scene.send("goal_reached") then return end
  for _, child in ipairs(self.node.children) do
    if child.particles then child.particles:burst(60) end
  end
end

return Goal
