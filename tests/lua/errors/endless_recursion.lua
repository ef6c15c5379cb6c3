-- expect: stack overflow
local function down(n) return 1 + down(n + 1) end
function start() down(1) end
