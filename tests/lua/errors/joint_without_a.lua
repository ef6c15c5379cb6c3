-- expect: joint.hinge: a: node expected, got nil
joint.hinge { axis = vec3.up }
