-- Shows the last throw again, from elsewhere and slower near the hoop. While the ball flies it writes down, tick by
-- tick, where every picture tagged "replayed" is; later it leads the pictures through that record. Bodies stand where
-- they are: a picture is only a child of its body, so the world does not notice.
local Replay = behaviour {
  speed = 0.8, speed_near = 0.25,     -- of the world's, and the same near the hoop
  near = 1.4,                         -- m
  keep_seconds = 3.5,                 -- of a longer throw, only its end
  leave_out = 0.4,                    -- s at the end: the ball only bounces
}

function Replay:start()
  self.pictures = scene.tagged("replayed")
  self.record = {}                    -- [tick][number of the picture] = { position, rotation }
  self.is_recording, self.is_playing = false, false
  self.clock = 0                      -- counts ticks of the record while it is shown
end

function Replay:on_throw() self.record, self.is_recording = {}, true end
function Replay:on_throw_over() self.is_recording = false end

function Replay:can_play() return #self.record > 1 and not self.is_recording and not self.is_playing end

function Replay:play()
  if not self:can_play() then return end
  self.is_playing, self.clock = true, 1
end

function Replay:stop()
  self.is_playing = false
  for _, picture in ipairs(self.pictures) do    -- back to their bodies
    picture.position, picture.rotation = vec3.zero, quat.identity
  end
end

function Replay:late_update(dt)
  if self.is_recording then self:write_down(dt) end
  if self.is_playing then self:show(dt) end
end

function Replay:write_down(dt)
  local poses = {}
  for i, picture in ipairs(self.pictures) do
    poses[i] = { position = picture.world_position, rotation = picture.world_rotation }
  end
  table.insert(self.record, poses)
  if #self.record > self.keep_seconds / dt then table.remove(self.record, 1) end
end

function Replay:show(dt)
  local tick = math.floor(self.clock)
  if tick >= #self.record - self.leave_out / dt then return self:stop() end
  local here, there = self.record[tick], self.record[tick + 1]
  local part = self.clock - tick                -- between two ticks of the record
  for i, picture in ipairs(self.pictures) do
    picture.world_position = here[i].position:lerp(there[i].position, part)
    picture.world_rotation = here[i].rotation:slerp(there[i].rotation, part)
  end
  local is_near = scene.get("ball/picture").world_position:distance(scene.get("hoop").world_position) < self.near
  self.clock = self.clock + (is_near and self.speed_near or self.speed)
end

return Replay
