-- expect: scene.add: body.mass must be above 0 (got 0)
scene.add { mesh = "sphere", body = { mass = 0 } }
