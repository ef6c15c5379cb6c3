-- expect: scene has no 'ad'; did you mean 'add'?
scene.ad { name = "ball" }
