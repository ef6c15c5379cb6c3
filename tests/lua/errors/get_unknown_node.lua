-- expect: scene.get: no node 'bal'; did you mean 'ball'?
scene.add { name = "ball" }
function start() scene.get("bal") end
