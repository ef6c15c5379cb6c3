-- expect: storage.save: a function cannot be stored
function start() storage.save("best", print) end
