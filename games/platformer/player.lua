-- Steers the character (scripts/std/character.lua) by keys, and brings it back after a fall.
local Player = behaviour {
  speed = 6,            -- m/s
  air_speed = 5.5,      -- m/s
  fall_depth = 9,       -- m below the place to which it would come back: lower than this it has fallen
}

function Player:start()
  self.character = self.node.behaviours.character
  self.home = self.node.world_position
end

function Player:update()
  local speed = self.character.is_grounded and self.speed or self.air_speed
  self.character:move(self:wish() * speed)
  if input.was_pressed("jump") then self.character:jump() end
  if input.was_released("jump") then self.character:cut_jump() end
  if self.node.world_position.y < self.home.y - self.fall_depth then self:on_hurt() end
end

-- Where the keys point, as seen from the camera; at most 1 long, so that two keys are no faster than one.
function Player:wish()
  local view = scene.camera
  local ahead = view.forward:with_y(0):normalized()
  return (view.right * input.axis("left", "right") + ahead * input.axis("back", "forward")):clamped(1)
end

-- Sent by hazards. Back to the last checkpoint.
function Player:on_hurt()
  sound.play("sounds/hurt.ogg", { at = self.node })
  input.rumble(0.6, 0.2)
  self.character:stop()
  self.node:teleport(self.home)
  scene.send("fell")
end

-- Sent by checkpoints.
function Player:on_checkpoint(place) self.home = place end

-- Sent by mushrooms.
function Player:on_bounce(height)
  self.character:launch(height)
  input.rumble(0.3, 0.15)
end

return Player
