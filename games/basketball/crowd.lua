-- People on the bleachers: each child of the node is one. They jump for points, the longer the more.
local Crowd = behaviour {
  jump = 0.35,                        -- m
  seconds_per_point = 0.5,
}

function Crowd:start()
  self.seats = {}
  for i, person in ipairs(self.node.children) do self.seats[i] = person.position end
  self.joy = 0                        -- s that are left of it
end

function Crowd:on_points(points)
  self.joy = math.min(self.joy + points * self.seconds_per_point, 3)
  sound.play("sounds/cheer.ogg", { at = self.node, volume = self.joy / 3 })
end

function Crowd:update(dt)
  if self.joy == 0 then return end
  self.joy = math.max(self.joy - dt, 0)
  for i, person in ipairs(self.node.children) do
    local height = self.jump * math.min(self.joy, 1)
    person.position = self.seats[i] + vec3.up * height * math.abs(math.sin(7 * time.now + 2.4 * i))   -- not all at once
  end
end

return Crowd
