local Enemy = behaviour { speed = 2 }

function Enemy:on_colision_enter(hit) print(hit.node.name, self.speed) end

return Enemy
