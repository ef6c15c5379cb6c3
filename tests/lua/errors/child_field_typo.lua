-- expect: scene.add: children[2]: no field 'colour'; did you mean 'color'?
scene.add { children = { { name = "a" }, { name = "b", colour = "red" } } }
