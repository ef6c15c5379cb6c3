---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What is on the screen, named anew in each tick, in draw_ui(). The screen is 720 units high whatever the window; `at` keeps things at its edges and corners, and panels and rows stack what is in them. Arrows, d-pad and left stick walk through the widgets of panels, enter, space and pad_a press them; a press that a widget took, the game does not see. A widget is known by its label: one that changes or comes twice needs an id.
---@class ui_module
---@field focused string? The id of the widget that has the focus of keys and pads.
---@field width number The screen's width in ui units: 1280 at 16:9.
---@field height number The screen's height in ui units: always 720.
ui = {}

--- Writes a text; line feeds begin new lines.
---@param text any
---@param options? ui_text_options
function ui.text(text, options) end

--- A button; true in the tick in which it was pressed: let go over it, or enter, space or pad_a.
---@param label string
---@param options? ui_button_options
---@return boolean
function ui.button(label, options) end

--- A switch; the state that it has now: volume_on = ui.toggle("Sound", volume_on).
---@param label string
---@param on boolean
---@param options? ui_button_options
---@return boolean
function ui.toggle(label, on, options) end

--- A slider; the value that it has now: volume = ui.slider("Volume", volume).
---@param label string
---@param value number
---@param options? ui_slider_options
---@return number
function ui.slider(label, value, options) end

--- A list of texts; which one is selected now, and true in the tick in which it was clicked or chosen with enter. Wheel and arrows scroll it.
---@param items any
---@param selected? integer
---@param options? ui_list_options
---@return integer, boolean
function ui.list(items, selected, options) end

--- A line to write in; its text now, and true in the tick in which enter ended it.
---@param label string
---@param text string
---@param options? ui_field_options
---@return string, boolean
function ui.field(label, text, options) end

--- The keys of an action. Press it, then the key that it shall have (escape: as before); true in the tick in which it changed.
---@param label string
---@param action string
---@param options? ui_button_options
---@return boolean
function ui.key(label, action, options) end

--- A bar that is filled to a fraction.
---@param fraction number
---@param options? ui_bar_options
function ui.bar(fraction, options) end

--- A filled rectangle.
---@param options? ui_box_options
function ui.box(options) end

--- A picture of the game's folder, as large as it is unless told otherwise.
---@param file string
---@param options? ui_image_options
function ui.image(file, options) end

--- Leaves a space; in a row it is a width.
---@param height number
function ui.space(height) end

--- What content() names stands in it, one below the other.
---@param options ui_panel_options
---@param content function
function ui.panel(options, content) end

--- What content() names stands side by side; buttons, sliders and bars share what is left.
---@param content function
function ui.row(content) end

--- How everything looks that says nothing else: ui.style { accent = "gold" }.
---@param options ui_style_options
function ui.style(options) end

--- Gives the focus of keys and pads to the widget with that id (its label, where it has none); without one to the first that is drawn.
---@param id? string
function ui.focus(id) end

--- How the ui looks where a widget says nothing else.
---@class ui_style_options
---@field accent? color|string Marks what has the focus, is on or is filled.
---@field panel? color|string Behind panels.
---@field text? color|string Of texts.
---@field size? number Line height of texts, units.

--- Options of ui.text.
---@class ui_text_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field size? number Line height, units; what ui.style says.
---@field color? color|string Of its letters; what ui.style says.
---@field width? number Units; longer lines are broken between words.
---@field align? "left"|"center"|"right" Where its lines stand within its width; what the panel says.

--- Options of ui.button, ui.toggle and ui.key.
---@class ui_button_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field id? string What tells it from others: needed where a label comes twice or changes. The label itself, where none is given.
---@field width? number Units; as wide as its panel, or as it needs.
---@field size? number Line height of its text, units.
---@field color? color|string Behind its text.
---@field text_color? color|string Of its text.
---@field enabled? boolean Off: it is pale and cannot be used.
---@field focus? boolean May keys and pads reach it? True in a panel, false outside of one.

--- Options of ui.slider.
---@class ui_slider_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field id? string What tells it from others: needed where a label comes twice or changes. The label itself, where none is given.
---@field width? number Units; as wide as its panel, or as it needs.
---@field size? number Line height of its text, units.
---@field color? color|string Behind its text.
---@field text_color? color|string Of its text.
---@field enabled? boolean Off: it is pale and cannot be used.
---@field focus? boolean May keys and pads reach it? True in a panel, false outside of one.
---@field min? number The value at its left end.
---@field max? number The value at its right end.
---@field step? number Values are whole steps from min; 0 allows all.

--- Options of ui.list.
---@class ui_list_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field id? string What tells it from others: needed where a label comes twice or changes. The label itself, where none is given.
---@field width? number Units; as wide as its panel, or as it needs.
---@field size? number Line height of its text, units.
---@field color? color|string Behind its text.
---@field text_color? color|string Of its text.
---@field enabled? boolean Off: it is pale and cannot be used.
---@field focus? boolean May keys and pads reach it? True in a panel, false outside of one.
---@field height? number Units; what does not fit is scrolled to. As high as it needs.

--- Options of ui.field.
---@class ui_field_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field id? string What tells it from others: needed where a label comes twice or changes. The label itself, where none is given.
---@field width? number Units; as wide as its panel, or as it needs.
---@field size? number Line height of its text, units.
---@field color? color|string Behind its text.
---@field text_color? color|string Of its text.
---@field enabled? boolean Off: it is pale and cannot be used.
---@field focus? boolean May keys and pads reach it? True in a panel, false outside of one.
---@field length? integer How many letters it takes.

--- Options of ui.bar.
---@class ui_bar_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field width? number Units; as wide as its panel, or 240.
---@field height? number Units.
---@field color? color|string Of the filled part; the accent of ui.style.

--- Options of ui.box.
---@class ui_box_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field width? number Units.
---@field height? number Units.
---@field radius? number Of its corners, units.
---@field color? color|string Its colour.

--- Options of ui.image.
---@class ui_image_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field width? number Units; where only the height is given, the picture keeps its shape.
---@field height? number Units; where only the width is given, the picture keeps its shape.
---@field color? color|string Multiplies the picture's colours.

--- Options of ui.panel.
---@class ui_panel_options
---@field at? "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.
---@field x? number Units to the right; without `at`, of its left edge from the screen's.
---@field y? number Units down; without `at`, of its upper edge from the screen's.
---@field width? number Units; as wide as its content needs.
---@field height? number Units; as high as its content needs.
---@field color? color|string Behind it; what ui.style says.
---@field align? "left"|"center"|"right" Where texts, rows and pictures stand that are narrower than the panel.
---@field padding? number Units between its edge and its content.
---@field gap? number Units between two things in it.
---@field radius? number Of its corners, units.
---@field focus? boolean May keys and pads reach the widgets in it?
