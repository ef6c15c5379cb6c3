-- expect: scene.add: body.colliders[1] has no field 'radus'; did you mean 'radius'?
scene.add { body = { colliders = { { shape = "sphere", radus = 1 } } } }
