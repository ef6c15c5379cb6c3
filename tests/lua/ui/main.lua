-- Draws what a test asks for, and writes down which presses reach the game.
local screen = require "screen"

function draw_ui() if screen.draw then screen.draw() end end
function on_press(name) table.insert(screen.heard, name) end
function on_release(name) table.insert(screen.heard, "-" .. name) end
