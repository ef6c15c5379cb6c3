local Broken = behaviour {}

function Broken:update()
  if time.now > 3 print("late") end
end

return Broken
