-- expect: scene.add: sound has no field 'pich'; did you mean 'pitch'?
scene.add { sound = { file = "boom.wav", pich = 2 } }
