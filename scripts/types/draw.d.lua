---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Lines and marks in the world, for one tick (from frame: one frame).
---@class draw_module
draw = {}

--- A line between two points.
---@param from vec3
---@param to vec3
---@param color? color|string
---@overload fun(from_x: number, from_y: number, from_z: number, to_x: number, to_y: number, to_z: number, color?: color|string)
function draw.line(from, to, color) end

--- An arrow from one point to another.
---@param from vec3
---@param to vec3
---@param color? color|string
---@overload fun(from_x: number, from_y: number, from_z: number, to_x: number, to_y: number, to_z: number, color?: color|string)
function draw.arrow(from, to, color) end

--- A small cross.
---@param position vec3
---@param size? number
---@param color? color|string
---@overload fun(position_x: number, position_y: number, position_z: number, size?: number, color?: color|string)
function draw.point(position, size, color) end

--- Lines through a list of points.
---@param points vec3[]
---@param color? color|string
function draw.path(points, color) end

--- The edges of a shape: "box", or a table as for a mesh; of a model its hull's.
---@param shape string or table
---@param position vec3
---@param rotation? quat
---@param color? color|string
---@overload fun(shape: string or table, position_x: number, position_y: number, position_z: number, rotation?: quat, color?: color|string)
function draw.shape(shape, position, rotation, color) end

--- Text at a place in the world; size is its line height in ui units (20).
---@param position vec3
---@param text string
---@param color? color|string
---@param size? number
---@overload fun(position_x: number, position_y: number, position_z: number, text: string, color?: color|string, size?: number)
function draw.text(position, text, color, size) end
