-- expect: behaviours.parts/slime.speed: number expected, got "fast"
scene.add { behaviours = { ["parts/slime"] = { speed = "fast" } } }
