-- Names of keys for people.
local keys = {}

local words = { escape = "Esc", pointer = "Left button" }

-- The first key of an action, as it stands on the keyboard.
function keys.name(action)
  local key = input.bindings(action)[1]
  if not key then return "-" end
  return words[key] or (key:sub(1, 1):upper() .. key:sub(2)):gsub("_", " ")
end

-- A text in which every {action} is the name of its key.
function keys.fill(text)
  return (text:gsub("{(%w+)}", keys.name))
end

return keys
