---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- vec3(x, y, z): a point or direction. + - * / work by component or with a number, == is exact. Values do not change.
---@class vec3_module
---@overload fun(x: number, y: number, z: number): vec3
---@field zero vec3 0, 0, 0.
---@field one vec3 1, 1, 1.
---@field up vec3 0, 1, 0.
---@field down vec3 0, -1, 0.
---@field left vec3 -1, 0, 0.
---@field right vec3 1, 0, 0.
---@field forward vec3 0, 0, -1.
---@field back vec3 0, 0, 1.
vec3 = {}

--- A point or direction; values do not change.
---@class vec3
---@operator add(vec3): vec3
---@operator sub(vec3): vec3
---@operator mul(number): vec3
---@operator mul(vec3): vec3
---@operator div(number): vec3
---@operator div(vec3): vec3
---@operator unm: vec3
---@field x number To the right, m.
---@field y number Up, m.
---@field z number Back (forward is -z), m.
local vec3 = {}

--- Its length.
---@return number
function vec3:length() end

--- The distance between two points.
---@param v vec3
---@return number
---@overload fun(self: vec3, v_x: number, v_y: number, v_z: number): number
function vec3:distance(v) end

--- The dot product.
---@param v vec3
---@return number
---@overload fun(self: vec3, v_x: number, v_y: number, v_z: number): number
function vec3:dot(v) end

--- The cross product.
---@param v vec3
---@return vec3
---@overload fun(self: vec3, v_x: number, v_y: number, v_z: number): vec3
function vec3:cross(v) end

--- The same direction with length 1; zero stays zero.
---@return vec3
function vec3:normalized() end

--- The same direction, at most this long.
---@param max number
---@return vec3
function vec3:clamped(max) end

--- The point at t on the way: 0 is this, 1 is v.
---@param v vec3
---@param t number
---@return vec3
---@overload fun(self: vec3, v_x: number, v_y: number, v_z: number, t: number): vec3
function vec3:lerp(v, t) end

--- The same with another x.
---@param x number
---@return vec3
function vec3:with_x(x) end

--- The same with another y.
---@param y number
---@return vec3
function vec3:with_y(y) end

--- The same with another z.
---@param z number
---@return vec3
function vec3:with_z(z) end

--- Turned by a rotation; the same as q * v.
---@param q quat
---@return vec3
function vec3:rotated(q) end

--- The angle between two directions, rad.
---@param v vec3
---@return number
---@overload fun(self: vec3, v_x: number, v_y: number, v_z: number): number
function vec3:angle(v) end

--- Its three numbers.
---@return number, number, number
function vec3:unpack() end
