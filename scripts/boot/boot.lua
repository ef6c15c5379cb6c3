-- The first script in every game: joins the parts below and gives the engine the functions that it calls.
--
-- These files are trusted: they alone see `core` (the engine's side, script/core.cpp) and Lua's debug library. A game's
-- files get what files.lua puts into their environment.
local core = ...

local boot = {}                      -- what the engine calls, by name
local parts = { core = core, boot = boot }
for _, name in ipairs { "names", "files", "behaviours", "tasks", "frame_state", "handlers", "variables", "reload", "bot" } do
  parts[name] = core.part(name)(parts)
end

boot.exports = { task = parts.tasks.task, property = parts.behaviours.property, input = parts.handlers.input }
return boot
