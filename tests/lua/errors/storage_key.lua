-- expect: storage.save: argument 1 (key): string expected, got the number 3
function start() storage.save(3, "best") end
