-- expect: task.loop: the function ended without waiting; put wait(...) in it
function start() task.loop(function() end) end
