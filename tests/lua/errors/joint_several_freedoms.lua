-- expect: joint.speed: a cylindrical has several freedoms; read joint.slide.speed
local ring = scene.add { mesh = "box", body = { mass = 1 } }
local rod = joint.cylindrical { a = ring, axis = vec3.up }
function start() print(rod.speed) end
