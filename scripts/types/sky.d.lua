---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Sky and fog: node.sky.
---@class sky
---@field top color|string Color overhead.
---@field horizon color|string Color at the horizon.
---@field ground color|string Color below the horizon, and of the light from below.
---@field fog_color? color|string What far things fade to; nil: the horizon's color.
---@field fog_start number Where fog begins, m from the eye.
---@field fog_end number Where nothing else is seen, m from the eye; 0: no fog.
---@field brightness number Of the light that comes from the sky.
---@field exposure number Of the whole picture; 2 is twice as bright.
local sky = {}

--- Sky, air and fog around everything; the first visible one in tree order counts.
---@class sky_options
---@field top? color|string Color overhead.
---@field horizon? color|string Color at the horizon.
---@field ground? color|string Color below the horizon, and of the light from below.
---@field fog_color? color|string What far things fade to; nil: the horizon's color.
---@field fog_start? number Where fog begins, m from the eye.
---@field fog_end? number Where nothing else is seen, m from the eye; 0: no fog.
---@field brightness? number Of the light that comes from the sky.
---@field exposure? number Of the whole picture; 2 is twice as bright.
