-- expect: node:destroy: the root of the scene cannot be destroyed
function start() scene.root:destroy() end
