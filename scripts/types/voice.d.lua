---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- A sound that plays: what sound.play gives.
---@class voice
---@field volume number 1 is as recorded; 0 to 4.
---@field pitch number 2 is an octave higher and half as long; 0.1 to 10.
---@field is_playing boolean False once it was stopped or has come to its end, by the game's time.
local voice = {}

--- Ends it, over so many seconds (0).
---@param fade? number
function voice:stop(fade) end
