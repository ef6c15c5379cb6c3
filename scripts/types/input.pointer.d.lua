---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The pointer: a mouse, a pen or a finger.
---@class input.pointer_module
---@field x number From the left, in ui units: 0 to ui.width.
---@field y number From the top, in ui units: 0 to 720.
---@field dx number How far it moved to the right in this tick, ui units.
---@field dy number How far it moved down in this tick, ui units.
---@field is_over_ui boolean Is it over a button or another part of the ui?
---@field captured boolean Hidden and endless, for looking around: x and y stand, dx and dy go on. While the game is paused, shows an error or is not in front the pointer is free; escape frees it until the next click.
input.pointer = {}
