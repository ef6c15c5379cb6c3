-- expect: scene.add: body.group: unknown group 'balls'
scene.add { mesh = "sphere", body = { group = "balls" } }
