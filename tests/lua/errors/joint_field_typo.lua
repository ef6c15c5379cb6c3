-- expect: joint.slider: no field 'axsi'; did you mean 'axis'?
local box = scene.add { mesh = "box", body = { mass = 1 } }
joint.slider { a = box, axsi = vec3.up }
