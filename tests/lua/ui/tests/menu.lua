-- scripts/std/menu: pages, the way back, and where the focus is.
local menu = require "menu"
local screen = require "screen"

local pages = {}
local played = 0

pages.title = function()
  menu.heading("Tests")
  if ui.button("Play") then
    played = played + 1
    menu.close()
  end
  if ui.button("Settings") then menu.open("settings") end
end
pages.pause = function()
  if ui.button("Resume") then menu.back() end
  if ui.button("Settings") then menu.open("settings") end
end
pages.settings = function()
  menu.keys { jump = "Jump", left = "Left" }
  menu.back_button()
end

local function begin(page)
  played = 0
  screen.draw = function() menu.draw(pages) end
  menu.show(page)
  wait(0.1)
end

local function press_key(...)
  for _, key in ipairs { ... } do
    tap(key)
    wait(0.1)
  end
end

test("pages open over each other, and the back button leads back", function()
  begin("title")
  expect(is_on_screen("Tests")):equals(true)
  click("Settings")
  expect(menu.page()):equals("settings")
  click("Back")
  expect(menu.page()):equals("title")
  click("Play")
  expect(played):equals(1)
  expect(menu.page()):equals(nil)
  wait(0.1)
  expect(is_on_screen("Play")):equals(false)
end)

test("escape and pad_b go back, but do not close what was shown", function()
  begin("title")
  press_key("escape")
  expect(menu.page()):equals("title")
  click("Settings")
  press_key("escape")
  expect(menu.page()):equals("title")
  click("Settings")
  press_key("pad2_b")
  expect(menu.page()):equals("title")
end)

test("the press that opens a page does not close it, the next one does", function()
  begin("title")
  menu.close()
  local before = screen.draw
  screen.draw = function()
    if input.was_pressed("escape") and not menu.page() and not screen.values.opened then
      screen.values.opened = true
      menu.open("pause")
    end
    before()
  end
  press_key("escape")
  expect(menu.page()):equals("pause")
  press_key("escape")
  expect(menu.page()):equals(nil)
end)

test("a page begins at its first widget, and is come back to where it was left", function()
  begin("title")
  press_key("down")
  expect(ui.focused):equals("Settings")
  press_key("enter")
  expect(ui.focused):equals("Jump")
  press_key("down", "down", "enter")
  expect(menu.page()):equals("title")
  expect(ui.focused):equals("Settings")
end)

test("keys of actions are changed on a page, and it says what it shows", function()
  begin("settings")
  expect(is_on_screen("Jump")):equals(true)
  click("Left")
  press_key("escape")                  -- leaves the key, not the page
  expect(menu.page()):equals("settings")
  click("Left")
  press_key("k")
  expect(input.bindings("left")[1]):equals("k")
end)

test("a page that is not there is named", function()
  begin("title")
  menu.show("titel")
  local ok, text
  screen.draw = function() ok, text = pcall(menu.draw, pages) end
  wait(0.1)
  expect(ok):equals(false)
  expect(text):contains("menu: there is no page 'titel'; write function pages.titel() ... end")
end)
