---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Keyframes that move a node: node.animation.
---@class animation
---@field clip string Name of the clip; empty: the file's first.
---@field file string A glTF file; empty: the mesh's own.
---@field speed number 1 is as recorded, -1 backwards.
---@field loop boolean Does it begin again at its end?
---@field playing boolean Does its time go on?
---@field time number Where it is in the clip, s.
local animation = {}

--- Keyframes from a model file, played on a mesh's parts or on child nodes of the same names.
---@class animation_options
---@field clip? string Name of the clip; empty: the file's first.
---@field file? string A glTF file; empty: the mesh's own.
---@field speed? number 1 is as recorded, -1 backwards.
---@field loop? boolean Does it begin again at its end?
---@field playing? boolean Does its time go on?
---@field time? number Where it is in the clip, s.
