-- A platform that goes to and fro, turns, or both, and carries what stands on it. Needs body = "kinematic": a kinematic
-- body that is given positions has the velocity of that motion.
--
--   { name = "lift", body = "kinematic", mesh = "box", behaviours = { platform = { travel = [0, 3, 0], seconds = 4 } } }
--
-- It sends nothing.
local Platform = behaviour {
  travel = vec3.zero,   -- m, from its first place to the other
  seconds = 3,          -- from end to end
  wait = 1,             -- s that it rests at each end
  turn_speed = 0,       -- rad/s about its own y
}

function Platform:start()
  self.home = self.node.position
  self.clock = 0
end

function Platform:update(dt)
  self.clock = self.clock + dt
  if self.travel ~= vec3.zero then self.node.position = self.home + self.travel * self:along() end
  if self.turn_speed ~= 0 then self.node:turn(vec3.up, self.turn_speed * dt) end
end

-- 0 at home, 1 at the other end; it sets off and arrives gently.
function Platform:along()
  local half = self.seconds + self.wait
  local round = self.clock % (2 * half)
  local there = math.clamp((round % half - self.wait) / self.seconds, 0, 1)
  if round >= half then there = 1 - there end
  return 0.5 - 0.5 * math.cos(math.pi * there)
end

return Platform
