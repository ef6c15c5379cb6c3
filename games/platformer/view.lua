-- Turns the follow camera (scripts/std/follow_camera.lua): by mouse and stick while one plays, by itself at the title.
local settings = require("settings").values

local View = behaviour {
  stick_speed = 2.2,    -- rad/s
  mouse_speed = 0.004,  -- rad for each unit of the screen, of which it is 720 high
  title_distance = 12,  -- m, and the height above the player, for a wide picture
  title_height = 5.5,
  title_heading = 0.45, -- rad, to and fro about it
}

function View:start()
  self.follow = self.node.behaviours.follow_camera
  self.near, self.low = self.follow.distance, self.follow.height
  self.is_title = false
end

-- Sent by main.lua.
function View:on_title()
  self.is_title = true
  self.follow.distance, self.follow.height = self.title_distance, self.title_height
end

function View:on_play()
  if not self.is_title then return end
  self.is_title = false
  tween(self.follow, 1.2, { distance = self.near, height = self.low, heading = 0 }, { ease = "in_out" })
end

function View:update(dt)
  if self.is_title then
    self.follow.heading = self.title_heading + 0.3 * math.sin(0.2 * time.now)
    return
  end
  local right = input.axis("look_left", "look_right") * self.stick_speed * dt
  local up = input.axis("look_down", "look_up") * self.stick_speed * dt
  if input.pointer.captured then
    right, up = right + input.pointer.dx * self.mouse_speed, up - input.pointer.dy * self.mouse_speed
  end
  self.follow:look(right * settings.camera_speed, up * settings.camera_speed * (settings.upside_down and -1 or 1))
end

return View
