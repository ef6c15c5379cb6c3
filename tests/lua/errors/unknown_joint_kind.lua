-- expect: joint has no 'hing'; did you mean 'hinge'?
joint.hing { axis = vec3.up }
