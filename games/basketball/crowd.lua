-- People on the bleachers: each child of the node is one. They jump for points, the higher the more.
local Crowd = behaviour { jump = 0.12, most = 0.5 }   -- m, per point and at most

function Crowd:start()
  self.seats = {}
  for i, person in ipairs(self.node.children) do self.seats[i] = person.position end
end

function Crowd:on_points(points)
  local height = math.min(points * self.jump, self.most)
  for i, person in ipairs(self.node.children) do
    person.position = self.seats[i]
    tween(person, random.between(0.14, 0.2), { position = self.seats[i] + vec3.up * height },
      { ease = "out", back = true, delay = random.between(0, 0.25) })
  end
end

return Crowd
