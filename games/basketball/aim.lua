-- Aiming: pull back with the pointer, as with a slingshot, or lead the aim with arrows or a stick. A pull sideways turns
-- the throw, a pull back gives its speed, both linear and clamped; the lift is always the same.
local settings = require "settings"

local Aim = behaviour {
  slowest = 5, fastest = 10,          -- m/s, at no pull and at full pull
  widest_degrees = 45,                -- to either side, at full pull
  lift_degrees = 60,
  full_pull = 300,                    -- ui units; the screen is 720 high
  least_pull = 20,                    -- a shorter one throws nothing
  keys_speed = 150,                   -- ui units/s, by arrows or stick
  preview_seconds = 0.9,
}

function Aim:start()
  self.is_allowed = false
  self.by = "nothing"                 -- "nothing", "pointer", "keys"
  self.right, self.back = 0, 0        -- the pull
  self.from_x, self.from_y = 0, 0     -- where the pointer's pull began
  self.facing = vec3.forward          -- towards the hoop, from where the ball is
  self.arc = scene.get("arc").behaviours.arc
  self.ball = self.node.behaviours.ball
end

-- The velocity of a pull to the right and back. It flies to the other side, like a stone from a slingshot.
function Aim:velocity_of(right, back)
  local lift = math.rad(self.lift_degrees)
  local turn = math.rad(self.widest_degrees) * math.clamp(right / self.full_pull, -1, 1)
  local speed = math.lerp(self.slowest, self.fastest, math.clamp(back / self.full_pull, 0, 1))
  local ahead = quat.axis_angle(vec3.up, turn) * self.facing
  return (ahead * math.cos(lift) + vec3.up * math.sin(lift)) * speed
end

-- Where a ball thrown now will be, every 0.05 s. With no damping this is the flight itself, tick by tick.
function Aim:points_of(velocity)
  local points = {}
  for i = 1, self.preview_seconds // 0.05 do
    local t = i * 0.05
    points[i] = self.ball.home + velocity * t + physics.gravity * (t * t / 2)
  end
  return points
end

function Aim:throw()
  self.by = "nothing"
  if self.back >= self.least_pull then self.ball:throw(self:velocity_of(self.right, self.back)) end
end

function Aim:by_pointer()
  if input.was_pressed("pointer") then
    self.by, self.from_x, self.from_y = "pointer", input.pointer.x, input.pointer.y
  end
  if self.by ~= "pointer" then return end
  local side = settings.slingshot and 1 or -1
  self.right, self.back = (input.pointer.x - self.from_x) * side, input.pointer.y - self.from_y
  if input.was_released("pointer") then self:throw() end
end

function Aim:by_keys(dt)
  local left, harder = input.axis("aim_right", "aim_left"), input.axis("softer", "harder")
  if (left ~= 0 or harder ~= 0) and self.by == "nothing" then
    self.by = "keys"
    self.back = math.max(self.back, self.full_pull / 3)
  end
  if self.by ~= "keys" then return end
  self.right = math.clamp(self.right + left * self.keys_speed * dt, -self.full_pull, self.full_pull)
  self.back = math.clamp(self.back + harder * self.keys_speed * dt, 0, self.full_pull)
  if input.was_pressed("throw") then self:throw() end
end

function Aim:update(dt)
  if not self.is_allowed then
    self.by = "nothing"
  elseif self.ball.state == "held" then
    self:by_pointer()
    self:by_keys(dt)
  end
  local shows = settings.arc and self.by ~= "nothing"
  self.arc:show(shows and self:points_of(self:velocity_of(self.right, self.back)) or {})
end

function Aim:draw_ui()
  if self.by == "nothing" then return end
  ui.bar(self.back / self.full_pull, { at = "bottom", width = 360, color = "orange" })
end

return Aim
