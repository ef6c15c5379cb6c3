-- expect: scene.add: a function cannot be stored
scene.add { name = "ball", color = function() end }
