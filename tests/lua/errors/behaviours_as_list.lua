-- expect: behaviours: a table by name expected
scene.add { behaviours = { "parts/slime" } }
