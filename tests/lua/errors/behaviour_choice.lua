-- expect: behaviours.parts/slime.mood: one of calm, angry expected, got "angri"; did you mean 'angry'?
scene.add { behaviours = { ["parts/slime"] = { mood = "angri" } } }
