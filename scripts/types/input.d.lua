---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Keys, buttons and the pointer, sampled once a tick. Actions are named in game.json. Keys are named by their place on an American board. All names of keys, buttons and pads: 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, a, apostrophe, b, backslash, backspace, c, caps_lock, comma, d, delete, down, e, end, enter, equals, escape, f, f1, f10, f11, f12, f2, f3, f4, f5, f6, f7, f8, f9, g, grave, h, home, i, insert, j, k, keypad_0, keypad_1, keypad_2, keypad_3, keypad_4, keypad_5, keypad_6, keypad_7, keypad_8, keypad_9, keypad_divide, keypad_enter, keypad_minus, keypad_multiply, keypad_period, keypad_plus, l, left, left_alt, left_bracket, left_ctrl, left_shift, left_super, less, m, menu, minus, n, num_lock, o, p, pad1_a, pad1_b, pad1_back, pad1_down, pad1_guide, pad1_left, pad1_left_shoulder, pad1_left_stick, pad1_left_trigger, pad1_left_x+, pad1_left_x-, pad1_left_y+, pad1_left_y-, pad1_right, pad1_right_shoulder, pad1_right_stick, pad1_right_trigger, pad1_right_x+, pad1_right_x-, pad1_right_y+, pad1_right_y-, pad1_start, pad1_up, pad1_x, pad1_y, pad2_a, pad2_b, pad2_back, pad2_down, pad2_guide, pad2_left, pad2_left_shoulder, pad2_left_stick, pad2_left_trigger, pad2_left_x+, pad2_left_x-, pad2_left_y+, pad2_left_y-, pad2_right, pad2_right_shoulder, pad2_right_stick, pad2_right_trigger, pad2_right_x+, pad2_right_x-, pad2_right_y+, pad2_right_y-, pad2_start, pad2_up, pad2_x, pad2_y, pad3_a, pad3_b, pad3_back, pad3_down, pad3_guide, pad3_left, pad3_left_shoulder, pad3_left_stick, pad3_left_trigger, pad3_left_x+, pad3_left_x-, pad3_left_y+, pad3_left_y-, pad3_right, pad3_right_shoulder, pad3_right_stick, pad3_right_trigger, pad3_right_x+, pad3_right_x-, pad3_right_y+, pad3_right_y-, pad3_start, pad3_up, pad3_x, pad3_y, pad4_a, pad4_b, pad4_back, pad4_down, pad4_guide, pad4_left, pad4_left_shoulder, pad4_left_stick, pad4_left_trigger, pad4_left_x+, pad4_left_x-, pad4_left_y+, pad4_left_y-, pad4_right, pad4_right_shoulder, pad4_right_stick, pad4_right_trigger, pad4_right_x+, pad4_right_x-, pad4_right_y+, pad4_right_y-, pad4_start, pad4_up, pad4_x, pad4_y, pad_a, pad_b, pad_back, pad_down, pad_guide, pad_left, pad_left_shoulder, pad_left_stick, pad_left_trigger, pad_left_x+, pad_left_x-, pad_left_y+, pad_left_y-, pad_right, pad_right_shoulder, pad_right_stick, pad_right_trigger, pad_right_x+, pad_right_x-, pad_right_y+, pad_right_y-, pad_start, pad_up, pad_x, pad_y, page_down, page_up, pause, period, pointer, pointer_back, pointer_forward, pointer_middle, pointer_right, print_screen, q, r, right, right_alt, right_bracket, right_ctrl, right_shift, right_super, s, scroll_lock, semicolon, slash, space, t, tab, u, up, v, w, x, y, z.
---@class input_module
---@field pointer input.pointer Where the pointer is, and how it moved.
---@field wheel number Steps of the wheel in this tick, away from you.
input = {}

--- Is the key, button or action held?
---@param name string
---@return boolean
function input.is_down(name) end

--- Was it pressed in this tick?
---@param name string
---@return boolean
function input.was_pressed(name) end

--- Was it let go in this tick?
---@param name string
---@return boolean
function input.was_released(name) end

--- How far it is pressed, 0 to 1.
---@param name string
---@return number
function input.value(name) end

--- -1 to 1: how far the second is pressed minus the first.
---@param low string
---@param high string
---@return number
function input.axis(low, high) end

--- Gives an action other keys, until the game ends; with { save = true } also in its later runs.
---@param action string
---@param names string[]
---@param options? table
function input.bind(action, names, options) end

--- The raw names that an action has.
---@param action string
---@return string[]
function input.bindings(action) end

--- Gives an action the keys of game.json back and forgets what was saved; without an action all of them.
---@param action? string
function input.reset_bindings(action) end

--- Hands the next key, button or stick that is pressed to fn(name), and to nobody else; fn(nil) where it is escape. Also while paused.
---@param fn function
function input.listen(fn) end

--- A key, button or stick in words for the screen: "Space", "Left stick right".
---@param name string
---@return string
function input.describe(name) end

--- Shakes a pad, or without its number all of them, where a pad can: strength 0 to 1, seconds 0 to 10. 0 ends it.
---@param strength number
---@param seconds number
---@param pad? integer
function input.rumble(strength, seconds, pad) end
