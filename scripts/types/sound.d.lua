---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What is heard from a node: node.sound.
---@class sound
---@field file string A WAV or OGG file.
---@field volume number 1 is as recorded.
---@field pitch number 2 is an octave higher and half as long.
---@field range number From so far away it cannot be heard, m.
---@field loop boolean Does it begin again at its end?
---@field playing boolean Is it to be heard?
---@field group string Whose volume it goes by: sound.groups.
local sound = {}

--- Something to be heard from where the node is.
---@class sound_options
---@field file? string A WAV or OGG file.
---@field volume? number 1 is as recorded.
---@field pitch? number 2 is an octave higher and half as long.
---@field range? number From so far away it cannot be heard, m.
---@field loop? boolean Does it begin again at its end?
---@field playing? boolean Is it to be heard?
---@field group? string Whose volume it goes by: sound.groups.
