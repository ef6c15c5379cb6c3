-- expect: 'print' belongs to the engine
function print() end
