-- expect: joint.slide.position can only be read; lead it there by joint.slide.motor
local ring = scene.add { mesh = "box", body = { mass = 1 } }
local rod = joint.cylindrical { a = ring, axis = vec3.up }
function start() rod.slide.position = 1 end
