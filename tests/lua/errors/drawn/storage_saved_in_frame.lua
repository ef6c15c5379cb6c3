-- expect: storage.save: frame only draws; change things in update or late_update
function frame(dt) storage.save("best", 3) end
