-- Actions in words for people: {jump} in a text becomes "Space", or the pad's button where a pad was used last.
local keys = {}

local pad = false

local function is_pad(name) return name:sub(1, 3) == "pad" end

local function notice_device()
  for _, action in ipairs { "left", "right", "forward", "back", "jump", "use" } do
    for _, name in ipairs(input.bindings(action)) do
      if input.is_down(name) then pad = is_pad(name) end
    end
  end
end

local function word(action)
  local names = input.bindings(action)
  for _, name in ipairs(names) do
    if is_pad(name) == pad then return input.describe(name) end
  end
  return #names > 0 and input.describe(names[1]) or "-"
end

function keys.fill(text)
  notice_device()
  return (text:gsub("{([%w_]+)}", word))
end

return keys
