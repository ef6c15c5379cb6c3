-- expect: time.scale: 0.01 to 100 expected, got -1; time.paused = true stops time
function start() time.scale = -1 end
