-- expect: the scripts need more memory than the
function start()
  local text = "x"
  while true do text = text .. text end   -- twice as long each time: full long before the watchdog looks
end
