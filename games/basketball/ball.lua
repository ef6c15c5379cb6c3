-- The ball: held, or flying. aim.lua throws it; hoop and targets ask it whether the throw still counts.
local sounds = { floor = "bounce", board = "board", rim = "rim", bracket = "rim" }   -- by what it hits; else a bounce

local Ball = behaviour {
  longest_flight = 4,                 -- s, until the next ball
  loudest = 6,                        -- N s: a harder hit is not louder
  after_floor = 0.6,                  -- s, the same once it met the floor
}

function Ball:start()
  self.home = self.node.position
  self.state = "held"                 -- "held", "flying"
  self.counts = false                 -- may this throw still score?
  self.scored = false
  self.clean = false                  -- has it touched nothing so far?
  self.over_at = 0
end

function Ball:wait_at(place)
  self.home = place
  self.node.body.type = "kinematic"
  self.node:teleport(place, quat.identity)
  self.state = "held"
end

function Ball:throw(velocity)
  local body = self.node.body
  body.type = "dynamic"
  body.velocity = velocity
  -- Backspin: to be seen, and to be felt at the board.
  body.angular_velocity = velocity:cross(vec3.up):normalized() * 12
  self.state, self.counts, self.scored, self.clean = "flying", true, false, true
  self.over_at = time.now + self.longest_flight
  sound.play("sounds/throw.ogg", { at = self.node })
  scene.send("throw")
end

-- A throw counts once: did it count now?
function Ball:score(points, words)
  if not self.counts then return false end
  self.counts, self.scored = false, true
  scene.send("points", points, words)
  return true
end

function Ball:update(dt)
  if self.state == "flying" and time.now >= self.over_at then
    self:wait_at(self.home)
    scene.send("throw_over", self.scored)
  end
end

function Ball:on_collision_enter(hit)
  self.clean = false
  local name = sounds[hit.node.name] or "bounce"
  sound.hit("sounds/" .. name .. ".ogg", hit, self.loudest)
  if hit.node.name == "floor" then self.over_at = math.min(self.over_at, time.now + self.after_floor) end
end

return Ball
