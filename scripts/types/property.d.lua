---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Declared properties of a behaviour, where a plain default says too little.
---@class property_module
property = {}

--- A number with bounds: property.number { 6, min = 0, max = 20 }.
---@param options table
---@return any
function property.number(options) end

--- One of some words, the first by default: property.choice { "calm", "angry" }.
---@param words string[]
---@return any
function property.choice(words) end

--- A node; in files a path from the file's root.
---@return any
function property.node() end

--- The path of a file.
---@param kind string
---@return any
function property.asset(kind) end
