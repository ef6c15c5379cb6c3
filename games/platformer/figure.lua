-- What is seen of the player: turns to where it walks, swings feet and hands, stretches as it jumps and is squashed as it lands.
local Figure = behaviour {
  turn_seconds = 0.06,  -- in which it turns two thirds of the way
  stride = 1.4,         -- m, of two steps
}

function Figure:start()
  self.walker = self.node.parent.behaviours.character
  self.limbs = {}
  for name, side in pairs { ["left foot"] = 1, ["right foot"] = -1, ["left hand"] = -1, ["right hand"] = 1 } do
    local limb = self.node:get(name)
    table.insert(self.limbs, { node = limb, rest = limb.position, side = side })
  end
  self.walked = 0       -- rad; a full turn is two steps
end

function Figure:update(dt)
  local way = (self.walker.velocity - self.walker.drift):with_y(0)     -- what it walks itself; platforms add to that
  local speed = way:length()
  if speed > 0.3 then
    local closer = 1 - math.exp(-dt / self.turn_seconds)
    self.node.world_rotation = self.node.world_rotation:slerp(quat.look(way), closer)
  end
  self.walked = self.walked + speed * dt * 2 * math.pi / self.stride
  self:swing(self.walker.is_grounded and math.min(speed / 6, 1) or 0.4)
end

-- Feet go to and fro, and up on the way ahead; hands the other way.
function Figure:swing(much)
  for _, limb in ipairs(self.limbs) do
    local ahead, lift = math.sin(self.walked) * limb.side, math.max(0, math.cos(self.walked) * limb.side)
    limb.node.position = limb.rest + vec3(0, 0.14 * lift, -0.22 * ahead) * much
  end
end

function Figure:on_jumped() tween(self.node, 0.12, { scale = vec3(0.85, 1.2, 0.85) }, { ease = "out", back = true }) end

function Figure:on_land(speed)
  local squash = math.clamp(speed / 40, 0, 0.35)
  tween(self.node, 0.09, { scale = vec3(1 + squash, 1 - squash, 1 + squash) }, { ease = "out", back = true })
end

return Figure
