---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The game itself: its report, its end.
---@class game_module
---@field title string From game.json.
---@field seed integer The seed of its random numbers.
---@field report table What the game tells of itself: game.report.score = 3 goes into --report.
---@field is_finished boolean Was game.finish() called?
game = {}

--- The game has come to its end; headless runs stop.
function game.finish() end

--- Starts everything anew, as F5 does.
function game.restart() end

--- Leaves.
function game.quit() end

--- The games in the folders of this one, for a menu: { path, about } each. A folder with a main.lua is a game, and so is every other script in a folder; about is its first comment.
---@return table[]
function game.list() end

--- Plays one of them at the end of the tick, from its start; F1 or its game.quit() comes back.
---@param path string
function game.open(path) end
