-- expect: node 'coin 3' was destroyed in dead_node.lua:4 at tick 0
local coin = scene.add { name = "coin 3" }

function start() coin:destroy() end
function update(dt)
  if not coin.is_alive then print(coin.position) end
end
