-- A behaviour for the error scripts to get wrong.
local Slime = behaviour {
  speed = 2,
  mood = property.choice { "calm", "angry" },
  size = property.number { 1, min = 1, max = 3 },
}

function Slime:start() self.happy = true end

return Slime
