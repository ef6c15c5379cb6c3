-- A lever to be pulled: stand near it and press "use". Sends its target "switched" (on).
local hud, keys = require "hud", require "keys"

local Handle = behaviour { target = property.node(), swing_degrees = 35 }

function Handle:start() self.is_near, self.on = false, false end

function Handle:on_trigger_enter(hit) if hit.node:has_tag("player") then self.is_near = true end end
function Handle:on_trigger_exit(hit) if hit.node:has_tag("player") then self.is_near = false end end

function Handle:update()
  if self.is_near and input.was_pressed("use") then self:pull() end
end

function Handle:pull()
  self.on = not self.on
  self.target:send("switched", self.on)
  sound.play("sounds/lever.ogg", { at = self.node })
  local degrees = self.on and -self.swing_degrees or self.swing_degrees
  tween(self.node:get("handle"), 0.3, { rotation_degrees = vec3(0, 0, degrees) }, { ease = "out_back" })
end

function Handle:draw_ui()
  if self.is_near then hud.hint(keys.fill("{use}: pull the lever")) end
end

return Handle
