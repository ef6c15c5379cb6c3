-- expect: scene.add: position: vec3 expected, got "up"
scene.add { position = "up" }
