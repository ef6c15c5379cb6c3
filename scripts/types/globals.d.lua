---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Declares a behaviour and its properties, each typed by its default; a behaviour's file returns it.
---@param properties? table
---@return behaviour
function behaviour(properties) end

--- Leads fields of a node, component, joint, behaviour or table to goals, in some seconds. Options: ease ("linear" "in" "out" "in_out" "out_back" "out_bounce"), delay, back, times. A new tween of a field replaces the old one.
---@param target any
---@param seconds number
---@param goals table
---@param options? table
---@return task
function tween(target, seconds, goals, options) end

--- In a task: goes on after that many seconds of game time.
---@param seconds number
function wait(seconds) end

--- In a task: goes on when condition() is true; false if the time was up first.
---@param condition function
---@param timeout? number
---@return boolean
function wait_until(condition, timeout) end

--- Prints the page of a module or object.
---@param x any
function help(x) end
