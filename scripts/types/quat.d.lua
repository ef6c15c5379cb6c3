---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- A rotation. q * r turns by r, then by q; q * v turns a vec3. Values do not change.
---@class quat_module
---@field identity quat No rotation.
quat = {}

--- A turn about an axis, right-handed.
---@param axis vec3
---@param radians number
---@return quat
---@overload fun(axis_x: number, axis_y: number, axis_z: number, radians: number): quat
function quat.axis_angle(axis, radians) end

--- From Euler angles, turned first about y, then x, then z.
---@param x number
---@param y number
---@param z number
---@return quat
function quat.euler_degrees(x, y, z) end

--- The rotation whose forward (-z) points there.
---@param forward vec3
---@param up? vec3
---@return quat
---@overload fun(forward_x: number, forward_y: number, forward_z: number, up?: vec3): quat
function quat.look(forward, up) end

--- A rotation; values do not change.
---@class quat
---@operator mul(vec3): vec3
---@operator mul(quat): quat
---@field x number First component.
---@field y number Second component.
---@field z number Third component.
---@field w number The scalar component.
---@field euler_degrees vec3 As Euler angles, turned first about y, then x, then z.
local quat = {}

--- The rotation back.
---@return quat
function quat:inverse() end

--- The rotation at t on the short way: 0 is this, 1 is r.
---@param r quat
---@param t number
---@return quat
function quat:slerp(r, t) end
