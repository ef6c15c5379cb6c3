---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The game's clock.
---@class time_module
---@field now number Game seconds since the start; it stands while paused.
---@field tick integer Ticks since the start.
---@field tick_seconds number The length of a tick, s.
---@field dropped_seconds number Game seconds left out since the start, as the computer was too slow for them: a frame makes up for 6 ticks at most. To be shown, not to be played by: it differs from run to run, and is 0 in bots' runs, tests and replays without a window.
---@field scale number 1 is normal, 0.5 half as fast: fewer ticks a second, each as long as ever. 0.01 to 100; menus of a paused game run as ever.
---@field paused boolean Stops updates, physics and tasks; input handlers of main.lua and draw_ui go on.
time = {}

--- One tick while paused.
function time.step() end
