-- Turns until the player touches it, then counts and is gone.
local Pickup = behaviour {
  value = 1,            -- coins
  turn_speed = 3,       -- rad/s
  sound = "sounds/coin.ogg",
}

function Pickup:start() self.disc = self.node:get("disc") end

function Pickup:update(dt) self.disc:turn(vec3.up, self.turn_speed * dt) end

function Pickup:on_trigger_enter(hit)
  if not hit.node:has_tag("player") then return end
  scene.send("pickup", self.value)
  sound.play(self.sound, { at = self.node, pitch = random.between(0.97, 1.03) })
  self.node.particles:burst(14)
  self.node:destroy()
end

return Pickup
