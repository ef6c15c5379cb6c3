-- expect: physics has no 'gravitiy'; did you mean 'gravity'?
physics.gravitiy = vec3.zero
