-- expect: task.every: seconds must be above 0 (got 0)
function start() task.every(0, print) end
