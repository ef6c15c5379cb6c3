---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Keys, buttons and the pointer, sampled once a tick.
---@class input_module
---@field pointer table Where the pointer is in ui units (720 high): x, y, and how it moved: dx, dy.
---@field wheel number Steps of the wheel in this tick, away from you.
input = {}

--- Is the key, button or action held?
---@param name string
---@return boolean
function input.is_down(name) end

--- Was it pressed in this tick?
---@param name string
---@return boolean
function input.was_pressed(name) end

--- Was it let go in this tick?
---@param name string
---@return boolean
function input.was_released(name) end

--- How far it is pressed, 0 to 1.
---@param name string
---@return number
function input.value(name) end

--- -1 to 1: how far the second is pressed minus the first.
---@param low string
---@param high string
---@return number
function input.axis(low, high) end

--- Gives an action other keys.
---@param action string
---@param names string[]
function input.bind(action, names) end

--- The raw names that an action has.
---@param action string
---@return string[]
function input.bindings(action) end
