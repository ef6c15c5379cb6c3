-- expect: scene.add: name: string expected, got 7
scene.add { name = 7 }
