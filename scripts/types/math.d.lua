---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The number, but at least low and at most high.
---@param x number
---@param low number
---@param high number
---@return number
function math.clamp(x, low, high) end

--- The number at t on the way: 0 is a, 1 is b.
---@param a number
---@param b number
---@param t number
---@return number
function math.lerp(a, b, t) end

--- The nearest whole number; halves go away from zero.
---@param x number
---@return number
function math.round(x) end

--- -1, 0 or 1.
---@param x number
---@return number
function math.sign(x) end

--- The value, brought nearer to the goal by at most a step.
---@param value number
---@param goal number
---@param step number
---@return number
function math.approach(value, goal, step) end
