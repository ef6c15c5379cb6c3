---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- The tree of nodes: adding, finding, loading.
---@class scene_module
---@field root node The node that all others hang from.
---@field name string The loaded scene's path, or "".
---@field camera node The node of the active camera; there is always one.
scene = {}

--- Adds a node. The table's keys are the node's properties, and `parent`, `children`, `prefab`.
---@param node node_options
---@return node
function scene.add(node) end

--- The node of that name or path ("level/door"); an error where there is none or several.
---@param path string
---@return node
function scene.get(path) end

--- The node of that name or path, or nil.
---@param path string
---@return node?
function scene.find(path) end

--- All nodes with that tag, in tree order.
---@param tag string
---@return node[]
function scene.tagged(tag) end

--- Replaces the loaded scene at the end of the tick. What main.lua declared stays.
---@param path string
function scene.load(path) end

--- Writes the loaded scene, as it is now, to path.json; only in a game's folder, while it is made.
---@param path string
function scene.save(path) end

--- Gives declared and loaded nodes their first state back at the end of the tick; added ones go.
function scene.restart() end

--- Calls on_<message> in main.lua and everywhere, at once; true if anyone listened.
---@param message string
---@param ... any
---@return boolean
function scene.send(message, ...) end
