-- expect: scene.add: body has no field 'restituton'; did you mean 'restitution'?
scene.add { mesh = "sphere", body = { restituton = 0.5 } }
