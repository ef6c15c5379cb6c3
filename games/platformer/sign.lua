-- A signpost: whoever stands near reads its text. {jump} in it is the key that jumps.
local hud, keys = require "hud", require "keys"

local Sign = behaviour { text = "" }

function Sign:start() self.is_near = false end
function Sign:on_trigger_enter(hit) if hit.node:has_tag("player") then self.is_near = true end end
function Sign:on_trigger_exit(hit) if hit.node:has_tag("player") then self.is_near = false end end

function Sign:draw_ui()
  if self.is_near then hud.hint(keys.fill(self.text)) end
end

return Sign
