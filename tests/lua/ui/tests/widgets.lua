-- Each widget by itself, through the pointer.
local screen = require "screen"

local function count_presses(label, options)
  screen.values[label] = 0
  screen.draw = function()
    if ui.button(label, options) then screen.values[label] = screen.values[label] + 1 end
  end
end

test("a button is pressed once by a click, and the game does not see it", function()
  count_presses("Play", { at = "center" })
  click("Play")
  wait(0.2)
  expect(screen.values.Play):equals(1)
  expect(#screen.heard):equals(0)
  expect(input.was_pressed("throw")):equals(false)
end)

test("let go beside it, a button was not pressed", function()
  count_presses("Play", { at = "center" })
  wait(0.1)
  point_at(640, 360)
  press("pointer")
  wait(0.1)
  point_at(100, 600)
  release("pointer")
  wait(0.1)
  expect(screen.values.Play):equals(0)
end)

test("pressed beside it and let go over it, a button was not pressed, and the game saw both", function()
  count_presses("Play", { at = "center" })
  wait(0.1)
  point_at(100, 600)
  press("pointer")
  wait(0.1)
  point_at(640, 360)
  release("pointer")
  wait(0.1)
  expect(screen.values.Play):equals(0)
  expect(table.concat(screen.heard, " ")):equals("pointer throw -pointer -throw")
end)

test("a button that is not enabled takes the press and does nothing", function()
  count_presses("Play", { at = "center", enabled = false })
  click("Play")
  wait(0.1)
  expect(screen.values.Play):equals(0)
  expect(#screen.heard):equals(0)
end)

test("a button that goes while it is held is not pressed when it comes back", function()
  count_presses("Play", { at = "center" })
  local draw = screen.draw
  wait(0.1)
  point_at(640, 360)
  press("pointer")
  wait(0.1)
  screen.draw = nil
  wait(0.1)
  screen.draw = draw
  wait(0.1)
  release("pointer")
  wait(0.1)
  expect(screen.values.Play):equals(0)
end)

test("a press and release within one tick press a button", function()
  count_presses("Play", { at = "center" })
  wait(0.1)
  point_at(640, 360)
  press("pointer")
  release("pointer")
  wait(0.1)
  expect(screen.values.Play):equals(1)
end)

test("a slider goes where the pointer drags it, beyond its end to its end", function()
  local value = 0
  screen.draw = function() value = ui.slider("Volume", value, { x = 100, y = 100, width = 600 }) end
  wait(0.1)
  -- label, number and track share 600 units; where the track is, the value tells by being neither end
  point_at(560, 120)
  press("pointer")
  wait(0.1)
  expect(value):above(0)
  expect(value):below(1)
  local middle = value
  point_at(561, 400)
  wait(0.1)
  expect(value):above(middle)
  point_at(1200, 400)
  wait(0.1)
  expect(value):equals(1)
  release("pointer")
  wait(0.1)
  point_at(100, 400)
  wait(0.1)
  expect(value):equals(1)
end)

test("a slider with steps gives whole steps", function()
  local value = 3
  screen.draw = function() value = ui.slider("Lives", value, { at = "center", width = 600, min = 1, max = 9, step = 2 }) end
  wait(0.1)
  for x = 640, 800, 20 do
    point_at(x, 360)
    press("pointer")
    wait(0)
    release("pointer")
    wait(0)
    expect((value - 1) % 2):equals(0)
  end
end)

test("a toggle turns with each click", function()
  local on = false
  screen.draw = function() on = ui.toggle("Sound", on, { at = "center" }) end
  click("Sound")
  expect(on):equals(true)
  click("Sound")
  expect(on):equals(false)
end)

test("a list selects the item that is clicked, and the wheel scrolls it", function()
  local items, selected, chosen = {}, nil, 0
  for i = 1, 20 do items[i] = "Item " .. i end
  screen.draw = function()
    ui.panel({ x = 0, y = 0, width = 300, padding = 0 }, function()
      local now, pressed = ui.list(items, selected, { height = 12 + 5 * 1.4 * 28 })   -- five items and the edge
      selected, chosen = now, chosen + (pressed and 1 or 0)
    end)
  end
  wait(0.1)
  local function choose(row)
    point_at(100, 6 + (row - 0.5) * 1.4 * 28)
    tap("pointer")
    wait(0.1)
  end
  choose(2)
  expect(selected):equals(2)
  expect(chosen):equals(1)
  turn_wheel(-3)
  wait(0.1)
  choose(2)
  expect(selected):equals(5)
  turn_wheel(-100)
  wait(0.1)
  choose(5)
  expect(selected):equals(20)
end)

test("a field takes what is typed, up to its length, and enter ends it", function()
  local name, ended = "A", false
  screen.draw = function()
    local now, done = ui.field("Name", name, { at = "center", length = 4 })
    name, ended = now, ended or done
  end
  click("Name")
  press("x")
  release("x")
  type_text("öxyz")
  wait(0.1)
  expect(name):equals("Aöxy")
  tap("backspace")
  wait(0.1)
  tap("backspace")
  wait(0.1)
  expect(name):equals("Aö")
  tap("backspace")
  wait(0.1)
  expect(name):equals("A")
  expect(ended):equals(false)
  tap("enter")
  wait(0.1)
  expect(ended):equals(true)
  expect(#screen.heard):equals(0)
end)

test("a key widget gives its action the next key, for keys and for pads apart", function()
  screen.draw = function() ui.panel({ at = "center" }, function() ui.key("Jump", "jump") end) end
  click("Jump")
  tap("j")
  wait(0.1)
  expect(table.concat(input.bindings("jump"), " ")):equals("j pad_a")
  click("Jump")
  tap("pad1_x")
  wait(0.1)
  expect(table.concat(input.bindings("jump"), " ")):equals("j pad_x")
  click("Jump")
  tap("escape")
  wait(0.1)
  expect(table.concat(input.bindings("jump"), " ")):equals("j pad_x")
  expect(#screen.heard):equals(0)
  tap("j")
  wait(0.1)
  expect(table.concat(screen.heard, " ")):equals("j jump -j -jump")
end)

test("the pointer is over the ui on widgets and on panels that hold some, not on texts", function()
  screen.draw = function()
    ui.text("Only words", { at = "top_left" })
    ui.panel({ at = "center", width = 400, height = 300 }, function() ui.button("Play") end)
    ui.panel({ at = "bottom", width = 400, height = 100 }, function() ui.text("Press space") end)
  end
  local function over(x, y)
    point_at(x, y)
    wait(0.05)
    return input.pointer.is_over_ui
  end
  wait(0.1)
  expect(over(640, 250)):equals(true)
  expect(over(640, 480)):equals(true)
  expect(over(60, 40)):equals(false)
  expect(over(640, 650)):equals(false)
  expect(over(1200, 360)):equals(false)
end)
