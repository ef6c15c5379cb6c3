-- expect: stopped: it ran for more than
function start()
  while true do pcall(function() while true do end end) end
end
