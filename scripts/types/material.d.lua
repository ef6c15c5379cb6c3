---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- How its surface looks: node.material.
---@class material
---@field color color|string A CSS name, "#rrggbb" or a color.
---@field texture string A PNG or JPEG file; the color tints it, and where it is less than half opaque there is a hole.
---@field texture_size number How many metres the picture covers before it repeats, m; 0: once over each face.
---@field roughness number 0 is a mirror, 1 is chalk.
---@field metalness number 1 is metal: reflections take its color.
---@field glow number Light of its own; 1 shows the color at full brightness in the dark.
---@field opacity number 0 is invisible.
local material = {}

--- How a mesh looks.
---@class material_options
---@field color? color|string A CSS name, "#rrggbb" or a color.
---@field texture? string A PNG or JPEG file; the color tints it, and where it is less than half opaque there is a hole.
---@field texture_size? number How many metres the picture covers before it repeats, m; 0: once over each face.
---@field roughness? number 0 is a mirror, 1 is chalk.
---@field metalness? number 1 is metal: reflections take its color.
---@field glow? number Light of its own; 1 shows the color at full brightness in the dark.
---@field opacity? number 0 is invisible.
