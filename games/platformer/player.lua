-- Steers the character (scripts/std/character.lua) by keys, and brings it back after a fall.
local Player = behaviour {
  speed = 6,            -- m/s
  air_speed = 5.5,      -- m/s
  turn_seconds = 0.06,  -- in which it turns two thirds of the way to where it walks
  fall_limit = -6,      -- m; lower than this it has fallen
}

function Player:start()
  self.character = self.node.behaviours.character
  self.figure = self.node:get("figure")           -- what is seen; the node itself is a capsule that need not turn
  self.home = self.node.world_position
end

function Player:update(dt)
  local wish = self:wish()
  local speed = self.character.is_grounded and self.speed or self.air_speed
  self.character:move(wish * speed)
  if input.was_pressed("jump") then self.character:jump() end
  if input.was_released("jump") then self.character:cut_jump() end

  if wish:length() > 0.1 then
    self.figure.rotation = self.figure.rotation:slerp(quat.look(wish), 1 - math.exp(-dt / self.turn_seconds))
  end
  if self.node.world_position.y < self.fall_limit then self:on_hurt() end
end

-- Where the keys point, as seen from the camera; at most 1 long, so that two keys are no faster than one.
function Player:wish()
  local view = scene.camera
  local ahead = view.forward:with_y(0):normalized()
  return (view.right * input.axis("left", "right") + ahead * input.axis("back", "forward")):clamped(1)
end

-- The figure stretches as it jumps and is squashed as it lands.
function Player:on_jumped() tween(self.figure, 0.12, { scale = vec3(0.85, 1.2, 0.85) }, { ease = "out", back = true }) end

function Player:on_land(speed)
  local squash = math.clamp(speed / 40, 0, 0.35)
  tween(self.figure, 0.09, { scale = vec3(1 + squash, 1 - squash, 1 + squash) }, { ease = "out", back = true })
end

-- Sent by hazards. Back to the last checkpoint.
function Player:on_hurt()
  print("respawn")
  self.character:stop()
  self.node:teleport(self.home)
  scene.send("fell")
end

-- Sent by checkpoints.
function Player:on_checkpoint(place) self.home = place end

return Player
