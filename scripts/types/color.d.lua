---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- color(r, g, b, a) with numbers from 0 to 1, or color "orange". Wherever a color is taken, a CSS name or "#rrggbb" will do.
---@class color_module
---@overload fun(r: number, g: number, b: number, a?: number): color
---@overload fun(name: string): color
color = {}

--- From hue, saturation and value, each 0 to 1.
---@param h number
---@param s number
---@param v number
---@return color
function color.hsv(h, s, v) end

--- A colour; values do not change.
---@class color
---@field r number Red, 0 to 1.
---@field g number Green, 0 to 1.
---@field b number Blue, 0 to 1.
---@field a number Opacity, 0 to 1.
local color = {}

--- The colour at t on the way: 0 is this, 1 is d.
---@param d color|string
---@param t number
---@return color
function color:lerp(d, t) end

--- The same with another opacity.
---@param a number
---@return color
function color:with_alpha(a) end
