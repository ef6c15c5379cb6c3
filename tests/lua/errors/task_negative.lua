-- expect: task.after: seconds: a number of 0 or more expected, got -1
function start() task.after(-1, print) end
