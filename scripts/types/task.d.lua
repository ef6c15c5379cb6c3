---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Things that happen later or go on for a while.
---@class task_module
task = {}

--- Calls fn(...) after some seconds.
---@param seconds number
---@param fn function
---@param ... any
---@return task
function task.after(seconds, fn, ...) end

--- Calls fn(...) again and again, that many seconds apart.
---@param seconds number
---@param fn function
---@param ... any
---@return task
function task.every(seconds, fn, ...) end

--- Runs fn(...) as a task, in which wait() and wait_until() work.
---@param fn function
---@param ... any
---@return task
function task.spawn(fn, ...) end

--- Runs fn(...) as a task again and again; it must wait somewhere.
---@param fn function
---@param ... any
---@return task
function task.loop(fn, ...) end

--- What task.after and its like return, and tween.
---@class task
---@field is_done boolean Has it ended?
local task = {}

--- Ends it.
function task:stop() end

--- In a task: goes on when that one has ended.
function task:wait() end

--- Calls fn(...) when it has ended; returns the task.
---@param fn function
---@param ... any
---@return task
function task:and_then(fn, ...) end
