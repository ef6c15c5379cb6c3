-- expect: scene.add: no field 'positon'; did you mean 'position'?
scene.add { name = "ball", positon = vec3(0, 1, 0) }
