-- Where things are, and what a bot can see of them.
local screen = require "screen"

test("is_on_screen knows widgets by label and id, and texts by their words", function()
  screen.draw = function()
    ui.text("Game over", { at = "center" })
    ui.button("Again", { at = "bottom", id = "again button" })
  end
  wait(0.1)
  for _, label in ipairs { "Game over", "Again", "again button" } do expect(is_on_screen(label)):equals(true) end
  expect(is_on_screen("Play")):equals(false)
  screen.draw = nil
  wait(0.1)
  expect(is_on_screen("Again")):equals(false)
end)

test("click says what there is where the label is unknown", function()
  screen.draw = function() ui.button("Again", { at = "bottom" }) end
  expect(function() click("Agian") end):raises("click: no widget 'Agian' on the screen; there are: Again")
end)

test("one label twice is an error, and an id tells them apart", function()
  local message
  screen.draw = function()
    ui.button("Play", { at = "top" })
    local _, text = pcall(ui.button, "Play", { at = "bottom" })
    message = text
    ui.button("Play", { at = "left", id = "second" })
  end
  wait(0.1)
  expect(message):contains("ui.button: 'Play' is there twice in this tick; give one of them an id of its own: { id = \"Play 2\" }")
  expect(is_on_screen("second")):equals(true)
end)

test("a label that changes keeps its focus by its id", function()
  local n = 0
  screen.draw = function()
    ui.panel({ at = "center" }, function()
      ui.button("First")
      if ui.button("Pressed " .. n, { id = "count" }) then n = n + 1 end
    end)
  end
  wait(0.1)
  tap("down")
  wait(0.1)
  for _ = 1, 3 do
    tap("enter")
    wait(0.1)
  end
  expect(n):equals(3)
end)

test("the screen is 720 high, and things stand at its edges", function()
  expect(ui.height):equals(720)
  screen.draw = function()
    for _, at in ipairs { "top_left", "top_right", "bottom_left", "bottom_right" } do ui.button(at, { at = at, width = 200 }) end
  end
  wait(0.1)
  local function over(x, y)
    point_at(x, y)
    wait(0.05)
    return input.pointer.is_over_ui
  end
  -- margins are 24
  expect(over(25, 25)):equals(true)
  expect(over(23, 25)):equals(false)
  expect(over(ui.width - 25, 720 - 25)):equals(true)
  expect(over(ui.width - 25, 720 - 23)):equals(false)
  expect(over(ui.width - 24 - 199, 25)):equals(true)
  expect(over(ui.width - 24 - 201, 25)):equals(false)
end)
