-- A crate to be pushed about. One that has fallen off its island comes back to its first place.
local Crate = behaviour { fall_depth = 6 }      -- m below its first place

function Crate:start() self.home, self.turned = self.node.world_position, self.node.world_rotation end

function Crate:update()
  local body = self.node.body
  self.node.sound.volume = math.clamp(body.velocity:with_y(0):length() / 3, 0, 1)     -- it scrapes as it slides
  if self.node.world_position.y > self.home.y - self.fall_depth then return end
  self.node:teleport(self.home + vec3.up * 0.3, self.turned)
  body.velocity = vec3.zero
end

function Crate:on_collision_enter(hit) sound.hit("sounds/thud.ogg", hit, 150) end

return Crate
