-- expect: frame only draws
function frame(dt) task.after(1, print) end
