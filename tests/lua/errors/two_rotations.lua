-- expect: scene.add has both 'rotation' and 'rotation_degrees'; give one of them
scene.add { rotation = quat.identity, rotation_degrees = vec3.zero }
