-- expect: behaviours.parts/slime.size: 1 to 3 expected, got 9
scene.add { behaviours = { ["parts/slime"] = { size = 9 } } }
