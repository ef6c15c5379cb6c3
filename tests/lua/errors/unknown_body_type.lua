-- expect: scene.add: body.type: unknown 'dynamik'; expected one of dynamic, static, kinematic; did you mean 'dynamic'?
scene.add { mesh = "box", body = "dynamik" }
