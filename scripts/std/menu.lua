-- The pages of a menu: title, pause, settings, end. A page is a function that names what stands on it; which pages are
-- open, one over the other, is kept here, and escape, pad_b or a back button lead from one to that below.
--
--   local menu = require "menu"
--   local pages = {}
--
--   function pages.title()
--     menu.heading("Little Heights")
--     if ui.button("Play") then menu.close() end
--     if ui.button("Settings") then menu.open("settings") end
--     if ui.button("Quit") then game.quit() end
--   end
--
--   function pages.settings()
--     menu.heading("Settings")
--     menu.keys { jump = "Jump", pause = "Pause" }
--     menu.back_button()
--   end
--
--   function start() menu.show("title") end
--   function draw_ui() menu.draw(pages) end
--   function on_press(name)
--     if name == "pause" and not menu.page() then menu.open("pause") end
--   end
--   function update() time.paused = menu.page() == "pause" end
--
-- show(page)      this one alone; escape does not close it, so that a title or an end stays
-- open(page)      over what is open; escape, pad_b and pad_start go back
-- back() close()  the uppermost, or all
-- page()          the uppermost's name, or nil while none is open
-- draw(pages, options)   from draw_ui(); options as of ui.panel, { at = "center", width = 460, align = "center" } unless given
--
-- Parts of pages: heading(text), back_button(label), keys { action = "Label" }: a row for each, in alphabetical order of
-- the actions, whose changes are kept for later runs. It sends nothing.
local menu = {}

local open = {}                 -- pages, the uppermost last: { name, stays, focus }
local drawn                     -- the entry of the last tick
local drawing = false
local fresh = false             -- opened since the last draw: the press that opened a page must not close it

local function put(name, stays)
  if type(name) ~= "string" then error("menu: a page's name expected, got " .. tostring(name), 3) end
  open[#open + 1] = { name = name, stays = stays }
  fresh = not drawing
end

function menu.show(name)
  open = {}
  put(name, true)
end

function menu.open(name)
  if #open > 0 then open[#open].focus = ui.focused end
  put(name, false)
end

function menu.back()
  if #open > 0 then table.remove(open) end
end

function menu.close() open = {} end

function menu.page() return #open > 0 and open[#open].name or nil end

local function wants_back()
  for _, key in ipairs { "escape", "pad_b", "pad_start" } do
    if input.was_pressed(key) then return true end
  end
  return false
end

local plain = { at = "center", width = 460, align = "center" }

function menu.draw(pages, options)
  if #open > 0 and not open[#open].stays and not fresh and wants_back() then menu.back() end
  fresh = false
  local entry = open[#open]
  if not entry then drawn = nil return end
  local page = pages[entry.name]
  if not page then error(("menu: there is no page '%s'; write function pages.%s() ... end"):format(entry.name, entry.name), 2) end
  -- A page begins at its first widget; one that is come back to, where it was left.
  if entry ~= drawn then ui.focus(entry.focus) end
  drawn = entry
  drawing = true
  ui.panel(options or plain, page)
  drawing = false
end

-- ---- parts of pages

function menu.heading(text)
  ui.text(text, { size = 56 })
  ui.space(8)
end

function menu.back_button(label)
  if ui.button(label or "Back") then menu.back() end
end

function menu.keys(labels)
  for action, label in pairs(labels) do
    if ui.key(label, action) then input.bind(action, input.bindings(action), { save = true }) end
  end
end

return menu
