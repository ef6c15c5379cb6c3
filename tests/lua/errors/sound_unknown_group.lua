-- expect: sound.group: no group 'musik'; did you mean 'music'?
scene.add { sound = { file = "boom.wav", group = "musik" } }
