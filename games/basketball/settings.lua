-- What a player may choose, kept from one run to the next. Whoever needs a choice reads it here: settings.arc.
local settings = {
  music = 0.6, effects = 1,           -- volumes, 0 to 1
  arc = true,                         -- is the flight shown ahead?
  slingshot = true,                   -- pull to the right and it flies to the left; or else to the right
  replays = true,                     -- are great baskets shown again?
}
local stored = storage.load("settings", {})
for name, value in pairs(stored) do settings[name] = value end

function settings.apply() sound.groups.music, sound.groups.effects = settings.music, settings.effects end

function settings.set(name, value)
  if settings[name] == value then return end
  settings[name], stored[name] = value, value
  storage.save("settings", stored)
  settings.apply()
end

return settings
