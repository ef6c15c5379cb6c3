-- expect: wait: works only in a task; write task.spawn(function() wait(1) ... end)
function update(dt) wait(1) end
