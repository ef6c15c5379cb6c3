-- expect: scene.get: 2 nodes fit 'wheel': 'cart/wheel', 'wheel'
scene.add { name = "cart", children = { { name = "wheel" } } }
scene.add { name = "wheel" }
function start() scene.get("wheel") end
