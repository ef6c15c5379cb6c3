-- A basket: the ball comes into the ring from above and leaves it below. A throw from below is spoilt.
local Hoop = behaviour { points = 2 }

function Hoop:start() self.came_from_above = false end

local function is_above(node, other) return node.world_position.y > other.world_position.y end

function Hoop:on_trigger_enter(hit)
  local ball = hit.node.behaviours.ball
  if not ball then return end
  self.came_from_above = is_above(hit.node, self.node)
  if not self.came_from_above then ball.counts = false end
end

function Hoop:on_trigger_exit(hit)
  local ball = hit.node.behaviours.ball
  if not ball or not self.came_from_above or is_above(hit.node, self.node) then return end
  ball:score(self.points, "Basket!")
  tween(scene.get("net"), 0.12, { scale = vec3(1, 1.3, 1) }, { ease = "out", back = true })
end

return Hoop
