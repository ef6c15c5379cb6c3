-- Keys and pads in menus.
local screen = require "screen"

local function menu(...)
  local labels = { ... }
  screen.draw = function()
    ui.panel({ at = "center", width = 400 }, function()
      for _, label in ipairs(labels) do
        if ui.button(label) then table.insert(screen.values, label) end
      end
    end)
  end
  wait(0.1)
end

local function pressed() return table.concat(screen.values, " ") end

test("enter presses the first button of a menu, space and pad_a too", function()
  menu("Play", "Quit")
  for _, key in ipairs { "enter", "space", "pad_a", "pad2_a" } do
    tap(key)
    wait(0.1)
  end
  expect(pressed()):equals("Play Play Play Play")
  expect(#screen.heard):equals(0)
end)

test("arrows, d-pad and left stick walk down and up, and round", function()
  menu("One", "Two", "Three")
  local function go(key)
    tap(key)
    wait(0.1)
    tap("enter")
    wait(0.1)
  end
  for _, key in ipairs { "down", "pad_down", "pad_left_y-", "up", "pad1_up" } do go(key) end
  expect(pressed()):equals("Two Three One Three Two")
  expect(#screen.heard):equals(0)
end)

test("arrows go by place: across a row, and to the nearest below", function()
  screen.draw = function()
    ui.panel({ at = "center", width = 600 }, function()
      ui.row(function()
        for _, label in ipairs { "A", "B", "C" } do
          if ui.button(label) then table.insert(screen.values, label) end
        end
      end)
      if ui.button("Below") then table.insert(screen.values, "Below") end
    end)
  end
  wait(0.1)
  local function go(...)
    for _, key in ipairs { ... } do
      tap(key)
      wait(0.05)
    end
    tap("enter")
    wait(0.05)
  end
  go("right")
  go("right")
  go("right")                          -- there is nothing further right
  go("left")
  go("down")
  go("up")
  expect(pressed()):equals("B C C B Below A")
end)

test("an arrow that is held goes on, after a while and by the tick", function()
  menu("1", "2", "3", "4", "5", "6", "7", "8")
  press("down")
  wait(0.35)
  tap("enter")
  wait(0.4)                            -- 0.75 s: after 0.4 s once more every 0.1 s
  release("down")
  tap("enter")
  wait(0.1)
  expect(pressed()):equals("2 6")
end)

test("left and right move a slider that has the focus", function()
  local value = 0.5
  screen.draw = function() ui.panel({ at = "center" }, function() value = ui.slider("Volume", value) end) end
  wait(0.1)
  tap("right")
  wait(0.1)
  expect(value):near(0.55, 1e-12)
  tap("pad_left")
  wait(0.1)
  tap("left")
  wait(0.1)
  expect(value):near(0.45, 1e-12)
end)

test("up and down move in a list, and leave it at its ends", function()
  local selected = 1
  screen.draw = function()
    ui.panel({ at = "center", width = 300 }, function()
      selected = ui.list({ "a", "b", "c" }, selected, { height = 60 })
      if ui.button("Go") then table.insert(screen.values, "Go") end
    end)
  end
  wait(0.1)
  for _ = 1, 2 do
    tap("down")
    wait(0.05)
  end
  expect(selected):equals(3)
  tap("down")
  wait(0.05)
  tap("enter")
  wait(0.05)
  expect(pressed()):equals("Go")
  tap("up")
  wait(0.05)
  tap("up")
  wait(0.05)
  expect(selected):equals(2)
end)

test("a button that stands on its own leaves the keys to the game", function()
  screen.draw = function() if ui.button("Menu", { at = "top_right" }) then table.insert(screen.values, "Menu") end end
  wait(0.1)
  tap("space")
  tap("left")
  wait(0.1)
  expect(pressed()):equals("")
  expect(table.concat(screen.heard, " ")):equals("space jump left -space -jump -left")
end)

test("focus = true lets keys reach it, focus = false keeps them off a panel's", function()
  screen.draw = function()
    if ui.button("Free", { at = "top_right", focus = true }) then table.insert(screen.values, "Free") end
    ui.panel({ at = "center", focus = false }, function() if ui.button("In") then table.insert(screen.values, "In") end end)
  end
  wait(0.1)
  tap("enter")
  wait(0.1)
  tap("down")
  wait(0.1)
  tap("enter")
  wait(0.1)
  expect(pressed()):equals("Free Free")
end)

test("another page begins at its first widget, and ui.focus chooses one", function()
  menu("Play", "Settings")
  tap("down")
  wait(0.1)
  menu("Volume", "Back")
  tap("enter")
  wait(0.1)
  expect(pressed()):equals("Volume")
  menu("Play", "Settings")
  ui.focus("Settings")
  wait(0.1)
  tap("enter")
  wait(0.1)
  expect(pressed()):equals("Volume Settings")
end)

test("menus work while the game is paused", function()
  time.paused = true
  menu("Resume", "Quit")
  tap("down")
  wait(0.1)
  tap("enter")
  wait(0.1)
  click("Resume")
  expect(pressed()):equals("Quit Resume")
end)

test("what is pointed at has the focus, and a pointer at rest does not hold it", function()
  menu("One", "Two", "Three")
  click("Three")
  tap("up")
  wait(0.1)
  tap("enter")
  wait(0.1)
  expect(pressed()):equals("Three Two")
end)
