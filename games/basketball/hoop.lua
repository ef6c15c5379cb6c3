-- A basket: the ball comes into the ring from above and leaves it below. A throw from below is spoilt.
local Hoop = behaviour {
  clean_points = 1,                   -- more, if it touched nothing before
  net_leaves = 0.6,                   -- how much of its speed the net leaves to the ball
  confetti = 30,                      -- pieces of each colour
}

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
  hit.body.velocity = hit.body.velocity * self.net_leaves
  local points = scene.get("match").behaviours.match:spot().points
  local counted
  if ball.clean then
    counted = ball:score(points + self.clean_points, "Swish!")
  else
    counted = ball:score(points, "Basket!")
  end
  sound.play("sounds/swish.ogg", { at = self.node })
  if counted then self:celebrate() end
end

function Hoop:celebrate()
  for _, paper in ipairs(scene.get("confetti").children) do paper.particles:burst(self.confetti) end
end

return Hoop
