-- expect: task.after: fn: function expected, got nil; pass the function itself, without ()
local function greet() print("hello") end
function start() task.after(1, greet()) end
