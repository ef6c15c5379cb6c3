---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Rays, casts and the world's settings.
---@class physics_module
---@field gravity vec3 Acceleration of free fall, m/s^2.
---@field sleeping boolean May bodies at rest fall asleep?
---@field profile string What accuracy may cost: "fast", "balanced" or "exact" take 2, 4 or 16 substeps at least.
---@field substeps integer? How many small steps make a tick, at least, in place of the profile's; nil: as the profile says.
---@field iterations integer How often, at least, the solver goes over the contacts in each half of a substep; a blow takes more.
---@field threads integer How many threads a tick's physics may use, at most; more than the machine has are not taken. Nothing but its time depends on it.
---@field default_friction number Friction of a body that gives none.
---@field default_restitution number Restitution of a body that gives none.
---@field debug_view string What F3 steps through: none, colliders, joints, boxes, contacts, rays, velocities, names, or physics: all but boxes and names.
physics = {}

--- The first body that the ray hits, or nil. The direction may have any length but zero.
---@param origin vec3
---@param direction vec3
---@param length number
---@param filter? filter|filter_options
---@return hit?
---@overload fun(origin_x: number, origin_y: number, origin_z: number, direction_x: number, direction_y: number, direction_z: number, length: number, filter?: filter|filter_options): hit?
function physics.raycast(origin, direction, length, filter) end

--- The first body between two points, or nil.
---@param from vec3
---@param to vec3
---@param filter? filter|filter_options
---@return hit?
---@overload fun(from_x: number, from_y: number, from_z: number, to_x: number, to_y: number, to_z: number, filter?: filter|filter_options): hit?
function physics.raycast_to(from, to, filter) end

--- All bodies that the ray hits, by distance.
---@param origin vec3
---@param direction vec3
---@param length number
---@param filter? filter|filter_options
---@return hit[]
---@overload fun(origin_x: number, origin_y: number, origin_z: number, direction_x: number, direction_y: number, direction_z: number, length: number, filter?: filter|filter_options): hit[]
function physics.raycast_all(origin, direction, length, filter) end

--- Does the ray hit anything?
---@param origin vec3
---@param direction vec3
---@param length number
---@param filter? filter|filter_options
---@return boolean
---@overload fun(origin_x: number, origin_y: number, origin_z: number, direction_x: number, direction_y: number, direction_z: number, length: number, filter?: filter|filter_options): boolean
function physics.raycast_any(origin, direction, length, filter) end

--- The first body under the pointer, or nil.
---@param filter? filter|filter_options
---@return hit?
function physics.pick(filter) end

--- The first body that a moving shape touches, or nil.
---@param shape shape_options|string
---@param origin vec3
---@param direction vec3
---@param length number
---@param filter? filter|filter_options
---@return hit?
---@overload fun(shape: shape_options|string, origin_x: number, origin_y: number, origin_z: number, direction_x: number, direction_y: number, direction_z: number, length: number, filter?: filter|filter_options): hit?
function physics.cast(shape, origin, direction, length, filter) end

--- The nodes of the bodies that a shape touches.
---@param shape shape_options|string
---@param position vec3
---@param filter? filter|filter_options
---@return node[]
---@overload fun(shape: shape_options|string, position_x: number, position_y: number, position_z: number, filter?: filter|filter_options): node[]
function physics.overlap(shape, position, filter) end

--- How a shape lies against the bodies around it: a hit each, with the distance between the surfaces (negative: they overlap) and the normal that leads out.
---@param shape shape_options|string
---@param position vec3
---@param within number
---@param filter? filter|filter_options
---@return hit[]
---@overload fun(shape: shape_options|string, position_x: number, position_y: number, position_z: number, within: number, filter?: filter|filter_options): hit[]
function physics.penetrations(shape, position, within, filter) end

--- Compiles a filter to keep: { groups, tags, ignore, only, triggers = false, accept = function(node) end }.
---@param filter filter|filter_options
---@return filter
function physics.filter(filter) end

--- Figures of the last step: bodies, awake, joints, contacts, islands (what touches or is joined), substeps (the most that one of them took), step_ms.
---@return table
function physics.stats() end

--- The physical world.
---@class physics_options
---@field gravity? vec3 m/s^2.
---@field profile? "fast"|"balanced"|"exact" What accuracy may cost: "fast", "balanced" or "exact" take 2, 4 or 16 substeps at least.
---@field substeps? integer Parts of one step, at least, in place of the profile's; what is heavily loaded takes more by itself.
---@field iterations? integer Rounds over contacts in each half of a substep, at least; a blow takes more.
---@field sleeping? boolean May resting bodies fall asleep?
---@field default_friction? number Of a body that gives none.
---@field default_restitution? number Of a body that gives none.
---@field friction_combine? "average"|"min"|"max"|"multiply" How the frictions of two bodies become one.
---@field restitution_combine? "average"|"min"|"max"|"multiply" The same for restitution.
---@field threads? integer That a step may use, at most. Nothing but the time depends on them.
---@field groups? (string)[]|string Names of collision groups, at most 31.

---@class filter_options
---@field groups? string|string[]
---@field tags? string|string[]
---@field ignore? node|node[]
---@field only? node|node[]
---@field triggers? boolean
---@field accept? fun(node: node): boolean
