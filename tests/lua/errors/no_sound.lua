-- expect: the node has no sound: add one with node.sound =
local node = scene.add { name = "bell" }
function start() node.sound:play() end
