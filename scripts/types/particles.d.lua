---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Small sprites that rise from a node: node.particles.
---@class particles
---@field rate number How many begin in a second, 1/s.
---@field life number How long each is seen, s.
---@field speed number At their start, along the node's up direction, m/s.
---@field spread number How far they may stray from that direction; 180 degrees: all around.
---@field spread_degrees number The same in degrees.
---@field area vec3 Size of the box in which they begin, around the node, m.
---@field size number Across, at their start, m.
---@field size_end number Across, at their end, m.
---@field color color|string At their start.
---@field color_end? color|string At their end; nil: the color, fading.
---@field gravity_factor number How much gravity pulls them; below 0 they rise.
---@field damping number How fast the air stops them, 1/s: the speed falls as exp(-damping t).
---@field variation number By how much the life, speed and size of each may fall short: 0 makes all alike.
---@field glow number Light of their own, as of a material.
---@field texture string A PNG file; none: a soft disc.
---@field playing boolean Do new ones begin? A burst needs it not.
local particles = {}

--- So many begin at once, where the node is now.
---@param count integer
function particles:burst(count) end

--- Small sprites that rise from a node: smoke, sparks, dust. Once begun they go their own way: they stay behind a node that moves, and live on when it is hidden or destroyed.
---@class particles_options
---@field rate? number How many begin in a second, 1/s.
---@field life? number How long each is seen, s.
---@field speed? number At their start, along the node's up direction, m/s.
---@field spread? number How far they may stray from that direction; 180 degrees: all around.
---@field spread_degrees? number The same in degrees.
---@field area? vec3 Size of the box in which they begin, around the node, m.
---@field size? number Across, at their start, m.
---@field size_end? number Across, at their end, m.
---@field color? color|string At their start.
---@field color_end? color|string At their end; nil: the color, fading.
---@field gravity_factor? number How much gravity pulls them; below 0 they rise.
---@field damping? number How fast the air stops them, 1/s: the speed falls as exp(-damping t).
---@field variation? number By how much the life, speed and size of each may fall short: 0 makes all alike.
---@field glow? number Light of their own, as of a material.
---@field texture? string A PNG file; none: a soft disc.
---@field playing? boolean Do new ones begin? A burst needs it not.
