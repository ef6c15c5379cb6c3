-- A camera that stays behind a node, looks at it, and comes closer rather than going into a wall.
--
--   { name = "camera", camera = {}, behaviours = { follow_camera = { target = "player" } } }
--
-- It begins in the direction in which its node looks, and swings round slowly when the target walks sideways; towards
-- the camera and away from it the target walks straight. Put it below its target in the scene, so that it moves after
-- it. It sends nothing.
--   look(right, up)   turns the view by so many radians, for a mouse or a stick; for some seconds it then stays so
-- Since it turns, walk by its directions rather than the world's:
--
--   local view = scene.camera
--   local ahead = view.forward:with_y(0):normalized()
--   local wish = view.right * input.axis("left", "right") + ahead * input.axis("back", "forward")
--   self.node.behaviours.character:move(wish:clamped(1) * self.speed)
local FollowCamera = behaviour {
  target = property.node(),
  distance = 7,         -- m behind the target
  height = 3,           -- m above it
  head = 0.9,           -- m above the target's middle: from there the view is kept free, so that low things do not count
  smoothing = 0.1,      -- s in which it closes two thirds of a gap; 0 is rigid
  turn_speed = 0.8,     -- rad/s, when the target walks straight sideways; 0 keeps its direction
  hold_seconds = 2,     -- after look(), before it swings by itself again
  lowest_degrees = -15, -- look() tilts no lower than this against the rest position
  highest_degrees = 50, -- and no higher
}

local RADIUS = 0.25     -- m kept to walls, so that nothing is cut open at the edge of the picture
local COMES_BACK = 6    -- m/s, after a wall

function FollowCamera:start()
  local forward = self.node.forward
  self.heading = math.atan(-forward.x, -forward.z)      -- about y; 0 looks along -z
  self.tilt = 0                                         -- rad; above 0 it looks down from higher up
  self.held = 0                                         -- s that look() still holds
  self.focus = self.target and self.target.world_position or vec3.zero
  self.seen_at = self.focus
  self.reach = self.distance
end

function FollowCamera:look(right, up)
  if right == 0 and up == 0 then return end
  self.heading = self.heading - right
  self.tilt = math.clamp(self.tilt - up, math.rad(self.lowest_degrees), math.rad(self.highest_degrees))
  self.held = self.hold_seconds
end

function FollowCamera:late_update(dt)
  if not self.target or not self.target.is_alive then return end
  local position = self.target.world_position
  self.held = math.max(0, self.held - dt)
  self:turn(position - self.seen_at, dt)
  self.seen_at = position

  local closer = self.smoothing > 0 and 1 - math.exp(-dt / self.smoothing) or 1
  self.focus = self.focus:lerp(position, closer)
  local rest = vec3(0, self.height, self.distance)
  local back = quat.axis_angle(vec3.up, self.heading) * (quat.axis_angle(vec3.left, self.tilt) * rest)
  local head = self.focus + vec3.up * self.head
  local way = self.focus + back - head
  local direction, wanted = way:normalized(), way:length()
  local wall = physics.cast({ shape = "sphere", radius = RADIUS }, head, direction, wanted, { ignore = self.target })
  local free = wall and wall.distance or wanted
  self.reach = math.min(free, math.approach(self.reach, wanted, COMES_BACK * dt))
  self.node.world_position = head + direction * self.reach
  self.node:look_at(self.focus)
end

-- Swings by the part of the motion that goes sideways in the picture.
function FollowCamera:turn(moved, dt)
  moved = moved:with_y(0)
  local speed = moved:length() / dt
  if speed < 0.5 or self.turn_speed == 0 or self.held > 0 then return end
  local right = quat.axis_angle(vec3.up, self.heading) * vec3.right
  self.heading = self.heading - moved:normalized():dot(right) * self.turn_speed * dt
end

return FollowCamera
