-- expect: behaviours.parts/slime has no property 'sped'; did you mean 'speed'?
scene.add { behaviours = { ["parts/slime"] = { sped = 3 } } }
