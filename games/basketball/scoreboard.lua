-- A scoreboard of lamps: seven bars make a digit. It shows the seconds left and the score of the match.
local Scoreboard = behaviour {
  digit_width = 0.34, digit_height = 0.62, bar = 0.07,   -- m
  lit = color "#ffb43c", dark = color "#3a2a34",
}

-- Which bars are lit: top, upper left, upper right, middle, lower left, lower right, bottom.
local shapes = { [0] = "1110111", "0010010", "1011101", "1011011", "0111010",
  "1101011", "1101111", "1010010", "1111111", "1111011" }

function Scoreboard:start()
  self.match = scene.get("match").behaviours.match
  self.numbers = {
    clock = { shown = -1, digits = { self:digit(-1.55, 0), self:digit(-1.05, 0) } },
    score = { shown = -1, digits = { self:digit(0.35, 0), self:digit(0.85, 0), self:digit(1.35, 0) } },
  }
end

function Scoreboard:digit(x, y)
  local w, h = self.digit_width / 2, self.digit_height / 2
  local flat, upright = vec3(2 * w - self.bar, self.bar, 0.02), vec3(self.bar, h - self.bar / 2, 0.02)
  local bars = {}
  for i, place in ipairs { vec3(0, h, 0), vec3(-w, h / 2, 0), vec3(w, h / 2, 0), vec3(0, 0, 0),
    vec3(-w, -h / 2, 0), vec3(w, -h / 2, 0), vec3(0, -h, 0) } do
    bars[i] = scene.add { parent = self.node, position = vec3(x, y, 0.13) + place, color = self.dark,
      mesh = { shape = "box", size = place.x == 0 and flat or upright } }
  end
  return bars
end

function Scoreboard:show(number, value)
  if number.shown == value then return end
  number.shown = value
  for i = #number.digits, 1, -1 do
    local shape = shapes[value % 10]
    for b, bar in ipairs(number.digits[i]) do
      local on = shape:sub(b, b) == "1"
      bar.color = on and self.lit or self.dark
      bar.material.glow = on and 0.45 or 0
    end
    value = value // 10
  end
end

function Scoreboard:update(dt)
  self:show(self.numbers.clock, math.ceil(self.match.seconds_left))
  self:show(self.numbers.score, self.match.score)
end

return Scoreboard
