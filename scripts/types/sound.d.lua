---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What is heard from a node: node.sound.
---@class sound
---@field file string A WAV or OGG file.
---@field volume number 1 is as recorded.
---@field pitch number 2 is an octave higher and half as long.
---@field range number From so far away it cannot be heard, m; up to an eighth of it, it is heard in full.
---@field loop boolean Does it begin again at its end?
---@field playing boolean Does it play? Without loop it becomes false at the file's end.
---@field group string Whose volume it goes by: sound.groups.
local sound = {}

--- Plays it from the beginning.
function sound:play() end

--- Ends it.
function sound:stop() end

--- Sounds and music, and how loud they are.
---@class sound_module
---@field volume number How loud everything is: 0 is silence, 1 as recorded, 4 the most.
---@field groups table How loud each group of sounds is, 0 to 4: sound.groups.music = 0.5. There are "effects", "music" and what game.json adds under sound.groups.
sound = {}

--- Plays a WAV or OGG file once, or with loop until it is stopped. Options: at (a vec3, or a node that it moves with; nil: everywhere), volume (0 to 4; 1 is as recorded), pitch (0.1 to 10; 2 is an octave higher), range (30 m, from there on it is silent; up to an eighth of it, it is heard in full), loop, group ("effects"). A paused game holds it, unless it began while paused.
---@param file string
---@param options? table
---@return voice
function sound.play(file, options) end

--- Plays a file where two bodies met, as loud as they met: in full at an impulse of `full` N s or more, in proportion below. For on_collision_enter. Options as for play, without at.
---@param file string
---@param hit hit
---@param full number
---@param options? table
function sound.hit(file, hit, full, options) end

--- Plays a file again and again, in the group "music". One music plays at a time: another fades in while it fades out, the same goes on, nil is silence. It goes on when a scene is loaded. Options: volume, fade (1 s).
---@param file? string
---@param options? table
function sound.music(file, options) end

--- Something to be heard from where the node is.
---@class sound_options
---@field file? string A WAV or OGG file.
---@field volume? number 1 is as recorded.
---@field pitch? number 2 is an octave higher and half as long.
---@field range? number From so far away it cannot be heard, m; up to an eighth of it, it is heard in full.
---@field loop? boolean Does it begin again at its end?
---@field playing? boolean Does it play? Without loop it becomes false at the file's end.
---@field group? string Whose volume it goes by: sound.groups.
