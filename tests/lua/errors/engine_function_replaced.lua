-- expect: scene.add is a function of the engine and cannot be replaced
function start() scene.add = nil end
