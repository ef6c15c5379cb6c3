-- expect: storage has no 'laod'; did you mean 'load'?
function start() storage.laod("best", 0) end
