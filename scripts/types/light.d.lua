---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- A light that shines from a node: node.light.
---@class light
---@field type "sun"|"point"|"spot" A sun shines everywhere, a point all around, a spot in a cone.
---@field color color|string Color of the light.
---@field brightness number 1 is a clear day; of a point or spot light, at a quarter of its range.
---@field range number How far a point or spot light reaches, m.
---@field shadow boolean Does a sun cast shadows? Points and spots cast none.
---@field angle number A spot's whole cone.
---@field angle_degrees number The same in degrees.
local light = {}

--- A light; a sun or spot shines along its node's forward direction.
---@class light_options
---@field type? "sun"|"point"|"spot" A sun shines everywhere, a point all around, a spot in a cone.
---@field color? color|string Color of the light.
---@field brightness? number 1 is a clear day; of a point or spot light, at a quarter of its range.
---@field range? number How far a point or spot light reaches, m.
---@field shadow? boolean Does a sun cast shadows? Points and spots cast none.
---@field angle? number A spot's whole cone.
---@field angle_degrees? number The same in degrees.
