-- expect: vec3: three numbers expected, got 2; write vec3(x, y, z)
local up = vec3(0, 1)
