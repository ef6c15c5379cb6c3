---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Random numbers, seeded by the game.
---@class random_module
random = {}

--- A number from a to b.
---@param a number
---@param b number
---@return number
function random.between(a, b) end

--- One entry of a list.
---@param list any[]
---@return any
function random.choice(list) end

--- True with probability p.
---@param p number
---@return boolean
function random.chance(p) end

--- Mixes a list in place and returns it.
---@param list any[]
---@return any[]
function random.shuffle(list) end

--- A direction, all equally likely; length 1.
---@return vec3
function random.direction() end

--- A point in a sphere around zero, all equally likely.
---@param radius number
---@return vec3
function random.in_sphere(radius) end
