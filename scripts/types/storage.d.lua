---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What a game keeps from one run to the next, such as high scores and settings. Each game has a file of its own, found by its folder's name, title and author, in the place that the system has for such: ~/.local/share/tumble (or $XDG_DATA_HOME/tumble), %APPDATA%\tumble, ~/Library/Application Support/tumble. Bots and tests begin with nothing stored and leave nothing behind; a replay has what its recording began with.
---@class storage_module
storage = {}

--- Stores a copy of the value under the key: numbers, strings, booleans, vec3, quat, color and tables of them, 1 MB in all; nil removes the key. It is written to disk whole or not at all, after the tick.
---@param key string
---@param value any
function storage.save(key, value) end

--- A copy of what is stored under the key, or `default`. At the top level of a file: as it was when the game began.
---@param key string
---@param default? any
---@return any
function storage.load(key, default) end
