-- expect: the scripts need more memory than the
function start()
  local all = {}
  while true do all[#all + 1] = string.rep("x", 1000000) .. #all end
end
