-- Shakes a node for a moment: the camera at a landing, a sign that was hit. It moves its own node only, about the pose
-- in which that node started, and comes back to exactly there. Give a camera that follows something a child for it:
--
--   { name = "rig", behaviours = { follow_camera = { target = "player" } }, children = {
--     { name = "camera", camera = {}, behaviours = { shake = {} } } } }
--
-- Hears "shake" (strength, 0 to 1, 0.5 where none is given): node:send("shake", 0.3), or scene.send for all at once.
-- Shakes add up to 1 at most. It draws on no chance, so the game plays the same with and without it. It sends nothing.
local Shake = behaviour {
  distance = 0.25,      -- m, of the strongest shake
  turn_degrees = 3,     -- of the strongest shake, about its own z
  seconds = 0.6,        -- in which the strongest shake dies down
}

function Shake:start()
  self.home, self.home_rotation = self.node.position, self.node.rotation
  self.strength, self.clock = 0, 0
end

function Shake:on_shake(strength)
  self.strength = math.clamp(self.strength + (strength or 0.5), 0, 1)
end

-- Two sines that never meet again look like chance.
local function wave(clock, a, b) return 0.5 * (math.sin(clock * a) + math.sin(clock * b)) end

function Shake:late_update(dt)
  if self.strength == 0 then return end
  self.clock = self.clock + dt
  self.strength = math.max(0, self.strength - dt / self.seconds)
  if self.strength == 0 then
    self.node.position, self.node.rotation = self.home, self.home_rotation
    return
  end
  local much, clock = self.strength ^ 2, self.clock
  local way = vec3(wave(clock, 71, 43), wave(clock, 59, 83), 0) * (self.distance * much)
  self.node.position = self.home + self.home_rotation * way
  self.node.rotation = self.home_rotation * quat.axis_angle(vec3.back, math.rad(self.turn_degrees) * much * wave(clock, 67, 37))
end

return Shake
