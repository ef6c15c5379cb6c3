---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The eye: node.camera.
---@class camera
---@field field_of_view number Vertical opening; 60 degrees.
---@field field_of_view_degrees number The same in degrees.
---@field near number What is nearer is not drawn, m.
---@field far number What is farther is not drawn, m.
---@field active boolean The first active camera in tree order is drawn from.
local camera = {}

--- Where a point of the world is on the screen, in ui units, and whether it is in front.
---@param point vec3
---@return number, number, boolean
---@overload fun(self: camera, point_x: number, point_y: number, point_z: number): number, number, boolean
function camera:to_screen(point) end

--- The two ends of the line of sight through a place on the screen.
---@param x number
---@param y number
---@return vec3, vec3
function camera:ray(x, y) end

--- An eye that looks along its node's forward direction.
---@class camera_options
---@field field_of_view? number Vertical opening; 60 degrees.
---@field field_of_view_degrees? number The same in degrees.
---@field near? number What is nearer is not drawn, m.
---@field far? number What is farther is not drawn, m.
---@field active? boolean The first active camera in tree order is drawn from.
