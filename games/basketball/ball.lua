-- The ball. Press anywhere, pull back, let go: sideways aims, length gives the speed, both linear and clamped.
local Ball = behaviour {
  slowest = 5, fastest = 10,          -- m/s, at no pull and at full pull
  widest_degrees = 45,                -- to either side, at full pull
  lift_degrees = 60,                  -- always
  full_pull = 300,                    -- ui units; the screen is 720 high
  least_pull = 20,                    -- a shorter one throws nothing
  preview_seconds = 0.9,
  longest_flight = 4,                 -- s, until the next ball
  after_floor = 0.6,                  -- s, the same once it met the floor
}

function Ball:start()
  self.home = self.node.position
  self.state = "held"                 -- "held", "aiming", "flying"
  self.counts = false                 -- may this throw still score?
  self.scored = false
  self.pull_x, self.pull_y = 0, 0     -- where the pull began
  self.over_at = 0
end

-- The velocity that a pull to the right and back throws with: like a slingshot, to the other side.
function Ball:velocity_of(right, back)
  local lift = math.rad(self.lift_degrees)
  local turn = math.rad(self.widest_degrees) * math.clamp(right / self.full_pull, -1, 1)
  local speed = math.lerp(self.slowest, self.fastest, math.clamp(back / self.full_pull, 0, 1))
  return vec3(0, math.sin(lift), -math.cos(lift)):rotated(quat.axis_angle(vec3.up, turn)) * speed
end

-- Where a ball thrown now will be, every 0.05 s. With no damping this is the flight itself, tick by tick.
function Ball:arc(velocity)
  local points = {}
  for i = 1, self.preview_seconds // 0.05 do
    local t = i * 0.05
    points[i] = self.home + velocity * t + physics.gravity * (t * t / 2)
  end
  return points
end

function Ball:throw(velocity)
  local body = self.node.body
  body.type = "dynamic"
  body.velocity = velocity
  body.angular_velocity = vec3(12, 0, 0)   -- backspin: to be seen, and to be felt at the board
  self.state, self.counts, self.scored = "flying", true, false
  self.over_at = time.now + self.longest_flight
end

-- A throw counts once; hoop and targets ask here.
function Ball:score(points, words)
  if not self.counts then return end
  self.counts, self.scored = false, true
  scene.send("points", points, words)
end

function Ball:reset()
  scene.send("throw_over", self.scored)
  self.node.body.type = "kinematic"
  self.node:teleport(self.home)
  self.state = "held"
end

function Ball:aim()
  local right, back = input.pointer.x - self.pull_x, input.pointer.y - self.pull_y
  local velocity = self:velocity_of(right, back)
  if not input.was_released("pointer") then
    for _, point in ipairs(self:arc(velocity)) do draw.point(point, 0.025, "white") end
  elseif back < self.least_pull then
    self.state = "held"
  else
    self:throw(velocity)
  end
end

function Ball:update(dt)
  if self.state == "held" and input.was_pressed("pointer") then
    self.state = "aiming"
    self.pull_x, self.pull_y = input.pointer.x, input.pointer.y
  elseif self.state == "aiming" then
    self:aim()
  elseif self.state == "flying" and time.now >= self.over_at then
    self:reset()
  end
end

function Ball:on_collision_enter(hit)
  if hit.node.name == "floor" then self.over_at = math.min(self.over_at, time.now + self.after_floor) end
end

function Ball:draw_ui()
  if self.state ~= "aiming" then return end
  ui.bar((input.pointer.y - self.pull_y) / self.full_pull, { at = "bottom", width = 360, color = "orange" })
end

return Ball
