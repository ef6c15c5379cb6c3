-- expect: vec3 +: vec3 expected, got the number 1
local up = vec3.up + 1
