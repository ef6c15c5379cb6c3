-- What is seen and heard of the player: its figure turns to where it walks, swings feet and hands, stretches as it jumps,
-- is squashed as it lands, raises dust and cheers at the goal.
local Figure = behaviour {
  turn_seconds = 0.06,  -- in which it turns two thirds of the way
  stride = 1.4,         -- m, of two steps
}

function Figure:start()
  self.walker = self.node.behaviours.character
  self.figure = self.node:get("figure")
  self.dust = self.node:get("figure/dust").particles
  self.limbs = {}
  for name, side in pairs { ["left foot"] = 1, ["right foot"] = -1, ["left hand"] = -1, ["right hand"] = 1 } do
    local limb = self.figure:get(name)
    table.insert(self.limbs, { node = limb, rest = limb.position, side = side })
  end
  self.walked = 0       -- steps
  self.cheers = false
end

function Figure:update(dt)
  local way = (self.walker.velocity - self.walker.drift):with_y(0)     -- what it walks itself; platforms add to that
  local speed, is_grounded = way:length(), self.walker.is_grounded
  if self.cheers then
    way = (scene.camera.world_position - self.node.world_position):with_y(0)
    self.walker:jump()
  end
  if speed > 0.3 or self.cheers then self:turn_to(way, dt) end

  local before = self.walked
  self.walked = before + 2 * speed * dt / self.stride
  if is_grounded and math.floor(before) < math.floor(self.walked) then self:step() end
  self:swing(is_grounded and math.min(speed / 6, 1) or 0.4)
end

function Figure:turn_to(way, dt)
  local closer = 1 - math.exp(-dt / self.turn_seconds)
  self.figure.world_rotation = self.figure.world_rotation:slerp(quat.look(way), closer)
end

function Figure:step()
  self.dust:burst(2)
  sound.play("sounds/step.ogg", { at = self.node, pitch = random.between(0.9, 1.1), volume = 0.5 })
end

-- Feet go to and fro, and up on the way ahead; hands the other way.
function Figure:swing(much)
  local angle = math.pi * self.walked
  for _, limb in ipairs(self.limbs) do
    local ahead, lift = math.sin(angle) * limb.side, math.max(0, math.cos(angle) * limb.side)
    limb.node.position = limb.rest + vec3(0, 0.14 * lift, -0.22 * ahead) * much
  end
end

-- Sent by the character.
function Figure:on_jumped()
  self.dust:burst(6)
  sound.play("sounds/jump.ogg", { at = self.node, pitch = random.between(0.95, 1.05) })
  tween(self.figure, 0.12, { scale = vec3(0.85, 1.2, 0.85) }, { ease = "out", back = true })
end

function Figure:on_land(speed)
  local squash = math.clamp(speed / 40, 0, 0.35)
  self.dust:burst(4 + math.floor(squash * 40))
  sound.play("sounds/land.ogg", { at = self.node, volume = math.clamp(speed / 12, 0.2, 1) })
  tween(self.figure, 0.09, { scale = vec3(1 + squash, 1 - squash, 1 + squash) }, { ease = "out", back = true })
end

-- Sent by main.lua at the goal.
function Figure:on_hooray() self.cheers = true end

return Figure
