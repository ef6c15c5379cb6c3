---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Holds a key, button or action down from the next tick on.
---@param name string
function press(name) end

--- Lets it go.
---@param name string
function release(name) end

--- Presses it and lets go after some seconds, one tick where none are given.
---@param name string
---@param seconds? number
function tap(name, seconds) end

--- -1 to 1: presses the first name by the negative and the second by the positive part.
---@param low string
---@param high string
---@param value number
function set_axis(low, high, value) end

--- Moves the pointer to a place in ui units, or to a node or point of the world as the camera sees it; point_at(x, y, seconds) takes its time.
---@param x any
---@param y? number
---@param seconds? number
function point_at(x, y, seconds) end

--- Turns the wheel by so many steps, away from you.
---@param steps number
function turn_wheel(steps) end

--- Types a text, as on_text and fields hear it.
---@param text string
function type_text(text) end

--- Moves the pointer to the widget with that label or id, presses and lets go. Waits up to a second for it.
---@param label string
function click(label) end

--- Is there such a widget, or such a text?
---@param label string
---@return boolean
function is_on_screen(label) end

--- In tests/*.lua: one claim; it runs in a fresh game.
---@param claim string
---@param fn function
function test(claim, fn) end

--- In tests/*.lua: expect(v) and then :equals(x) :near(x, tolerance) :above(x) :below(x) :contains(x), or :raises(text) of a function.
---@param value any
---@return expectation
function expect(value) end

---@class expectation
---@field equals fun(self: expectation, other: any)
---@field near fun(self: expectation, other: any, tolerance: number)
---@field above fun(self: expectation, other: any)
---@field below fun(self: expectation, other: any)
---@field contains fun(self: expectation, part: any)
---@field raises fun(self: expectation, text: string)
