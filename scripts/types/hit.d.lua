---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What a ray found, or who touched whom: a record of its own, to keep as long as you like.
---@class hit
---@field node node The other's node; of a query, the node that was hit.
---@field body body? Its body.
---@field collider integer Which of its colliders, counted from 1.
---@field own_collider integer Which of mine, counted from 1.
---@field point vec3 Where, in the world, m.
---@field normal vec3 The surface's direction towards me, or towards the ray's origin.
---@field speed number How fast they approached when the tick began, m/s.
---@field impulse number What they pushed each other with in this tick, N s.
---@field velocity vec3 The other's velocity against mine, m/s.
---@field time number Of a trigger: when the shapes first or last touched, s on the clock of time.now, exact within the tick for what flies freely in it; of a stay or a query, time.now. A collision tells none.
---@field distance number Of a query: how far from the origin, m.
---@field origin vec3 Of a query: where it began.
---@field end_point vec3 Of a query: where it would have ended.
local hit = {}

--- All points where they touch.
---@return vec3[]
function hit:points() end
