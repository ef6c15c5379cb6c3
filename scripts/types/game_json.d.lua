---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- game.json: what a game says of itself before its scripts run.
---@class game_options
---@field title? string Stands in the window's title.
---@field version? string The game's own version, as you like to write it.
---@field author? string Who made it.
---@field icon? string A picture file for the window and the package.
---@field start_scene? string Scene to load at the start, without ending; empty: none.
---@field tick_rate? number Ticks of game logic and physics in a second, Hz.
---@field window? window_options The window.
---@field physics? physics_options The physical world; the same keys as the module's.
---@field sound? sound_settings_options Groups of sounds.
---@field actions? table<string, (string)[]|string> Names for input, each with the raw names that trigger it: "jump": ["space", "pad_a"].

--- The window's size.
---@class window_options
---@field width? integer Pixels.
---@field height? integer Pixels.
---@field fullscreen? boolean Start in full screen?

--- What is to be known of sounds before any plays.
---@class sound_settings_options
---@field groups? (string)[]|string Groups of sounds with a volume of their own, beside "effects" and "music": ["voices"].
