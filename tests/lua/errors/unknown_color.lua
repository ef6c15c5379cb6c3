-- expect: scene.add: color: unknown name 'oragne'; did you mean 'orange'?
scene.add { name = "ball", color = "oragne" }
