-- expect: time.scale: 0 to 100 expected, got -1
function start() time.scale = -1 end
