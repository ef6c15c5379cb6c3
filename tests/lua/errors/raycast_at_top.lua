-- expect: physics.raycast: not at the top level of a file, which runs again at every save; put it in start()
local hit = physics.raycast(vec3.zero, vec3.down, 10)
