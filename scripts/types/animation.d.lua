---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Keyframes that move a node: node.animation.
---@class animation
---@field clip string Name of the clip; empty: the file's first. Another one begins at its start, with a speed below 0 at its end.
---@field file string A glTF file; empty: the mesh's own.
---@field speed number 1 is as recorded, -1 backwards.
---@field loop boolean Does it begin again at its end?
---@field playing boolean Does its time go on? Of a clip that does not loop it is false at the end, and on_animation_end(clip) is called.
---@field time number Where it is in the clip, s.
local animation = {}

--- Keyframes from a model file: they move child nodes that bear the name of a node in the file, and where they are drawn the parts of the node's own model.
---@class animation_options
---@field clip? string Name of the clip; empty: the file's first. Another one begins at its start, with a speed below 0 at its end.
---@field file? string A glTF file; empty: the mesh's own.
---@field speed? number 1 is as recorded, -1 backwards.
---@field loop? boolean Does it begin again at its end?
---@field playing? boolean Does its time go on? Of a clip that does not loop it is false at the end, and on_animation_end(clip) is called.
---@field time? number Where it is in the clip, s.
