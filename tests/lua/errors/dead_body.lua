-- expect: node 'coin 3' was destroyed in 
local coin = scene.add { name = "coin 3", mesh = "sphere", body = { mass = 1 } }
local body

function start()
  body = coin.body
  task.after(0.1, coin.destroy, coin)
  task.after(0.2, function() body:apply_impulse(vec3.up) end)
end
