-- The player who touches it comes back here after a fall. Its flag rises and turns green, its lamp is lit.
local Checkpoint = behaviour { raise = 1.2 }      -- m above its node, where the player appears

function Checkpoint:start() self.is_reached = false end

function Checkpoint:on_trigger_enter(hit)
  if self.is_reached or not hit.node:has_tag("player") then return end
  self.is_reached = true
  hit.node:send("checkpoint", self.node.world_position + vec3.up * self.raise)
  scene.send("checkpoint_reached")

  local flag, lamp = self.node:get("flag"), self.node:get("lamp")
  tween(flag, 0.5, { position = flag.position:with_y(2.2), color = "limegreen" }, { ease = "out_back" })
  tween(lamp.light, 0.5, { brightness = 1.2 })
  lamp.particles:burst(24)
  sound.play("sounds/checkpoint.ogg", { at = self.node })
end

return Checkpoint
