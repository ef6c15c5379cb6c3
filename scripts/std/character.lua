-- A capsule that walks, jumps, climbs steps, rides platforms and pushes crates. It finds its way by casting its own
-- shape through the world, so it never passes through anything, however fast it is.
--
-- The node needs a kinematic body and a capsule as its mesh, or as its body's first collider:
--   mesh = { shape = "capsule", radius = 0.35, height = 1.7 }, body = "kinematic", behaviours = { character = {} }
--
-- Call from your own behaviour's update(), as self.node.behaviours.character:move(velocity), or from main.lua's:
--   move(velocity)   where to walk in this tick, m/s; a tick without it stands still
--   jump()           jumps now, or within buffer_seconds as soon as it lands
--   cut_jump()       the button was let go: a jump still rising ends early
--   launch(height)   thrown up so many metres, wherever it is; cut_jump() does not end it
--   stop()           forgets all motion, for after a teleport
-- Read: is_grounded, ground (the node it stands on, or nil), velocity (what it did in the last tick, m/s)
-- Sends to its node: "land" (speed, m/s) and "jumped".
--
-- Ground that turns about y turns it too; walking leaves its direction alone, so turn what is seen of it yourself.
--
-- It moves in late_update: after every update has had its say and after physics, when platforms are where this tick
-- leaves them. So the order of behaviours does not matter, and it never slips on what carries it.
local Character = behaviour {
  jump_height = 1.3,        -- m, of a full jump from the ground
  gravity = 24,             -- m/s^2; more than Earth's, since a true jump feels like one on the moon
  step_height = 0.35,       -- m, walked up without a jump
  slope_degrees = 45,       -- steeper ground is a wall, and slides off
  coyote_seconds = 0.1,     -- how long after the ledge a jump still counts
  buffer_seconds = 0.1,     -- how long before the landing a jump already counts
  push_force = 400,         -- N, against bodies in its way
  mass = 75,                -- kg, weighs on bodies that it stands on
}

local SKIN = 0.01           -- m kept to everything, so that it slides along seams and walls without touching them
local JUMP_CUT = 0.4        -- what a jump that is cut keeps of its speed
local FASTEST_FALL = 40     -- m/s
local LONG_AGO = math.huge

function Character:start()
  local mesh, collider = self.node.mesh, self.node.body.colliders[1]
  local shape = collider and collider.shape == "capsule" and collider or mesh
  self.shape = { shape = "capsule", radius = shape.radius, height = shape.height }
  self.others = physics.filter { ignore = self.node }
  self.wish = vec3.zero
  self.cut = false
  self.jump_age = LONG_AGO            -- s since jump() was called
  self:stop()
end

function Character:stop()
  self.is_grounded, self.ground, self.normal = false, nil, vec3.up
  self.foothold, self.stood_at = vec3.zero, vec3.zero   -- one point, as the ground and as the world see it
  self.ground_rotation = quat.identity                  -- the ground's, when it was stood on last
  self.climb = 0                      -- m/s upwards, in the air
  self.drift = vec3.zero              -- m/s, of the platform that it stands on or left
  self.air_age = LONG_AGO             -- s since it last stood
  self.is_launched = false            -- until it lands
  self.velocity = vec3.zero
end

function Character:move(velocity) self.wish = velocity:with_y(0) end
function Character:jump() self.jump_age, self.cut = 0, false end
function Character:cut_jump() self.cut = not self.is_launched end

function Character:launch(height)
  self.is_grounded, self.ground = false, nil
  self.climb = math.sqrt(2 * self.gravity * height)
  self.air_age, self.cut = LONG_AGO, false
  self.is_launched = true
end

function Character:late_update(dt)
  local before = self.node.world_position
  self.air_age = self.is_grounded and 0 or self.air_age + dt
  local place = self:push_out(self:ride(before, dt))
  self:take_off()
  if self.is_grounded then place = self:walk(place, dt) else place = self:fly(place, dt) end
  self.jump_age = self.jump_age + dt
  self.wish = vec3.zero
  self.velocity = (place - before) / dt
  if place ~= before then self.node.world_position = place end
end

-- ---- parts of a tick

-- Goes where the ground under it went. A ground that was destroyed carries nothing.
function Character:ride(place, dt)
  if not self.is_grounded then return place end
  self.drift = vec3.zero
  if not self.ground.is_alive then return place end
  self:turn_along(self.ground.world_rotation * self.ground_rotation:inverse())
  local carried = self.ground:to_world(self.foothold) - self.stood_at
  if carried == vec3.zero then return place end
  self.drift = carried / dt
  -- The ground has moved already, perhaps into the capsule: it must not stop its own passenger.
  return (self:sweep(place, carried, physics.filter { ignore = { self.node, self.ground } }))
end

-- Turns about y as far as the ground did.
function Character:turn_along(turned)
  local ahead = turned * vec3.forward
  local angle = math.atan(-ahead.x, -ahead.z)
  if math.abs(angle) > 1e-7 then self.node.world_rotation = quat.axis_angle(vec3.up, angle) * self.node.world_rotation end
end

-- Out of whatever moved into it.
function Character:push_out(place)
  for _ = 1, 4 do
    local nearest = physics.penetrations(self.shape, place, SKIN / 100, self.others)[1]
    if not nearest then break end
    place = place + nearest.normal * (SKIN - nearest.distance)
  end
  return place
end

function Character:take_off()
  local epsilon = 1e-9                -- ticks are counted in seconds, which are not exact
  if self.jump_age > self.buffer_seconds + epsilon or self.air_age > self.coyote_seconds + epsilon then return end
  self.climb = math.sqrt(2 * self.gravity * self.jump_height) + math.max(0, self.drift.y)
  self.is_grounded, self.ground = false, nil
  self.jump_age, self.air_age = LONG_AGO, LONG_AGO
  self.node:send("jumped")
end

-- Along the ground at full speed, up a step where the plain way is blocked, and down onto what is below.
function Character:walk(place, dt)
  local way = self:along_ground(self.wish) * dt
  local there, hit = self:slide(place, way, true)
  if hit then
    self:push(hit, dt)
    there = self:step(place, way, there) or there
  end
  local down, below = self:sweep(there, vec3.down * (self.step_height + SKIN))
  if below and self:holds(below, there) then
    self:stand(below)
    return down
  end
  self.is_grounded, self.ground = false, nil
  self.climb = 0
  return there
end

-- Through the air; a platform that it left still gives it its speed.
function Character:fly(place, dt)
  if self.cut and self.climb > 0 then self.climb, self.cut = self.climb * JUMP_CUT, false end
  local there, hit = self:slide(place, (self.wish + self.drift:with_y(0)) * dt, true)
  if hit then self:push(hit, dt) end

  local climb = math.max(self.climb - self.gravity * dt, -FASTEST_FALL)
  local rise = (self.climb + climb) / 2 * dt           -- exact under constant gravity
  self.climb = climb
  local to, met = self:sweep(there, vec3.up * rise)
  if not met then return to end
  if rise < 0 and self:holds(met, to) then return self:land(met, to) end

  -- A ceiling, or ground too steep to stand on: along it.
  local rest = vec3.up * (rise - (to.y - there.y))
  to = self:slide(to, rest - met.normal * rest:dot(met.normal), false)
  local moved = to.y - there.y
  if rise > 0 then self.climb = self.climb * math.clamp(moved / rise, 0, 1) end
  if rise < -SKIN and moved > rise * 0.1 then return self:land(met, to) end  -- wedged: let it jump out
  return to
end

function Character:land(hit, place)
  local speed = -self.climb
  self:stand(hit)
  self.climb = 0
  self.node:send("land", speed)
  return place
end

function Character:stand(hit)
  self.is_grounded, self.ground, self.normal = true, hit.node, self:face(hit)
  self.is_launched = false
  self.foothold = hit.node:to_local(hit.point)
  self.stood_at = hit.node:to_world(self.foothold)     -- so that ground at rest carries by exactly nothing
  self.ground_rotation = hit.node.world_rotation
  local body = hit.body
  if body.type == "dynamic" then body:apply_force(physics.gravity * self.mass, hit.point) end
end

-- ---- moving the capsule

-- As far along `way` as nothing is nearer than the skin; and the hit that ended it.
function Character:sweep(place, way, filter)
  local length = way:length()
  if length < 1e-9 then return place end
  local direction = way / length
  local hit = physics.cast(self.shape, place, direction, length + 4 * SKIN, filter or self.others)
  if not hit then return place + way end
  local free = hit.distance - SKIN / math.max(0.25, -hit.normal:dot(direction))
  if free >= length then return place + way end
  return place + direction * math.max(0, free), hit
end

-- Along `way`, turning aside at what is in it; and the first thing that was. With `walking`, what is too steep to
-- walk on is an upright wall, so that nobody is pressed up a cliff.
function Character:slide(place, way, walking)
  local first, last_normal
  local rest = way
  for _ = 1, 4 do
    local to, hit = self:sweep(place, rest)
    if not hit then return to, first end
    first = first or hit
    rest, place = rest - (to - place), to
    local normal = hit.normal
    if walking and not self:is_walkable(normal) and normal:with_y(0) ~= vec3.zero then normal = normal:with_y(0):normalized() end
    rest = rest - normal * rest:dot(normal)
    if last_normal and rest:dot(last_normal) < 0 then   -- a corner: only its crease is left
      local crease = normal:cross(last_normal):normalized()
      rest = crease * rest:dot(crease)
    end
    if rest:dot(way) <= 0 then break end                -- never back
    last_normal = normal
  end
  return place, first
end

-- Up, ahead and down; nil where that leads no farther than the plain way, or nowhere to stand.
function Character:step(place, way, plain)
  local ahead = way:with_y(0)
  local raised = self:sweep(place, vec3.up * self.step_height)
  local there = self:slide(raised, ahead, true)
  if (there - plain):dot(ahead) <= 1e-6 then return nil end
  local down, hit = self:sweep(there, vec3.down * (raised.y - place.y + SKIN))
  local feet = place.y - self.shape.height / 2 - SKIN
  if hit and hit.point.y - feet <= self.step_height + SKIN and self:holds(hit, there) then return down end
end

-- No more force than push_force, and no more speed than it walks with.
function Character:push(hit, dt)
  local body = hit.body
  if body.type ~= "dynamic" or hit.normal.y > 0.7 then return end
  local direction = -hit.normal:with_y(0):normalized()
  local missing = (self.wish - body.velocity):dot(direction)
  if missing > 0 then body:apply_impulse(direction * math.min(body.mass * missing, self.push_force * dt)) end
end

-- ---- what the ground is like

function Character:is_walkable(normal) return normal.y >= math.cos(math.rad(self.slope_degrees)) - 1e-6 end

-- The normal of the face beside a contact: where the round end touches an edge, its own normal says nothing.
function Character:face(hit)
  local outward = hit.normal:with_y(0):normalized()
  local ray = physics.raycast(hit.point - outward * 0.02 + vec3.up * 0.05, vec3.down, 0.1, self.others)
  return ray and ray.distance > 0 and ray.normal or hit.normal
end

-- Can it stand on what it would come down on?
function Character:holds(hit, place)
  if hit.normal.y <= 0 or not self:is_walkable(self:face(hit)) then return false end
  if self:is_walkable(hit.normal) or self.wish:dot(hit.normal) <= 0 then return true end
  -- It walks off an edge: down a step, if there is one, else over the ledge and into the air.
  local floor = physics.raycast(place, vec3.down, self.shape.height / 2 + SKIN + self.step_height, self.others)
  return floor ~= nil and self:is_walkable(floor.normal)
end

-- A horizontal velocity turned into the ground's plane, as fast as before.
function Character:along_ground(velocity)
  local speed = velocity:length()
  if speed == 0 then return velocity end
  local way = velocity - vec3.up * (velocity:dot(self.normal) / self.normal.y)
  return way * (speed / way:length())
end

return Character
