-- What a player may set. It is kept from run to run.
local settings = storage.load("settings", { music = 0.6, effects = 0.9, camera_speed = 1, upside_down = false })

-- Lets all that is set be heard and stored; called after each change.
local function apply()
  sound.groups.music, sound.groups.effects = settings.music, settings.effects
  storage.save("settings", settings)
end

return { values = settings, apply = apply }
