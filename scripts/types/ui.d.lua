---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Text and bars on the screen, called in draw_ui(). The screen is 720 units high.
---@class ui_module
---@field width number The screen's width in ui units: 1280 at 16:9.
---@field height number The screen's height in ui units: always 720.
ui = {}

--- Writes a text. Options: at ("top_left" ... "center" ... "bottom_right"), moved by x and y, or x and y alone; size, color.
---@param text any
---@param options? table
function ui.text(text, options) end

--- A bar that is filled to a fraction. Options: at, x, y as for text; width, height, color.
---@param fraction number
---@param options? table
function ui.bar(fraction, options) end

--- A filled rectangle, to stand behind text. Options: at, x, y as for text; width, height, color.
---@param options table
function ui.box(options) end
