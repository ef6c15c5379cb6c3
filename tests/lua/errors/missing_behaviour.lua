-- expect: scene.add: no behaviour 'parts/slme': there is no file parts/slme.lua in the game or in scripts/std; did you mean 'parts/slime'?
scene.add { behaviours = { ["parts/slme"] = {} } }
