-- The net: knots on cords, by Verlet's method. Each knot goes on as it went, falls, makes room for the ball, and is
-- pulled back by the cords above it. The topmost row hangs at the ring. At rest it costs nothing.
local Net = behaviour {
  columns = 10, rows = 4,
  top_radius = 0.215, bottom_radius = 0.12, height = 0.42,   -- m
  cord = 0.012,                       -- m thick
  ball_radius = 0.135,
  drag = 0.04,                        -- part of its speed that a knot loses in a tick
}

local rounds = 3                      -- over all cords, in each tick

function Net:start()
  self.knots, self.cords = {}, {}
  self.still_ticks = 0
  for row = 0, self.rows do
    for column = 1, self.columns do self.knots[self:index(row, column)] = self:knot(row, column) end
  end
  for row = 1, self.rows do           -- each knot hangs from two of the row above: a net of diamonds
    for column = 1, self.columns do
      local beside = row % 2 == 1 and column + 1 or column - 1
      self:tie(self:index(row, column), self:index(row - 1, column))
      self:tie(self:index(row, column), self:index(row - 1, beside))
    end
  end
  self:draw()
end

function Net:index(row, column) return row * self.columns + (column - 1) % self.columns + 1 end

function Net:knot(row, column)
  local down = row / self.rows
  local turn = (column + (row % 2) / 2) / self.columns * 2 * math.pi
  local radius = math.lerp(self.top_radius, self.bottom_radius, down ^ 0.7)
  local place = self.node.world_position + vec3(radius * math.cos(turn), -self.height * down, radius * math.sin(turn))
  return { place = place, before = place, home = place, is_tied = row == 0 }
end

function Net:tie(a, b)
  local knot_a, knot_b = self.knots[a], self.knots[b]
  local strand = scene.add { parent = self.node, color = "#f4efe6",
    mesh = { shape = "box", size = vec3(self.cord, self.cord, 1) } }
  table.insert(self.cords, { a = knot_a, b = knot_b, length = knot_a.place:distance(knot_b.place), strand = strand })
end

function Net:late_update(dt)
  local ball = scene.get("ball/picture")        -- what is seen, in a replay too
  local middle = self.node.world_position - vec3.up * (self.height / 2)
  if ball.world_position:distance(middle) < 0.6 then self.still_ticks = 0 end
  if self.still_ticks > 120 then return end
  self.still_ticks = self.still_ticks + 1
  for _, knot in ipairs(self.knots) do self:move(knot, ball.world_position, dt) end
  for _ = 1, rounds do
    for _, cord in ipairs(self.cords) do self:pull(cord) end
  end
  self:draw()
end

function Net:move(knot, ball, dt)
  if knot.is_tied then return end
  local way = (knot.place - knot.before) * (1 - self.drag)
  knot.before = knot.place
  -- Woven cords spring back to their shape; that and gravity balance at home.
  knot.place = knot.place + way + (knot.home - knot.place) * 0.03
  local out = knot.place - ball
  if out:length() < self.ball_radius then knot.place = ball + out:normalized() * self.ball_radius end
end

-- Brings both ends to the cord's length; what is tied stays.
function Net:pull(cord)
  local a, b = cord.a, cord.b
  local way = b.place - a.place
  local off = way * ((way:length() - cord.length) / way:length())
  if b.is_tied then
    a.place = a.place + off
  else
    a.place, b.place = a.place + off / 2, b.place - off / 2
  end
end

function Net:draw()
  for _, cord in ipairs(self.cords) do
    local strand, a, b = cord.strand, cord.a.place, cord.b.place
    strand.world_position = (a + b) / 2
    strand:look_at(b)
    strand.scale = vec3(1, 1, a:distance(b))
  end
end

return Net
