-- expect: color: numbers from 0 to 1 expected, got 255
local red = color(255, 0, 0)
