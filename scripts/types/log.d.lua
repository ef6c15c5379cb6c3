---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Lines for the author.
---@class log_module
log = {}

--- A line that warns.
---@param text string
function log.warn(text) end

--- A line that tells of an error; the script goes on.
---@param text string
function log.error(text) end

--- A live line on the screen.
---@param name string
---@param value any
function log.watch(name, value) end
