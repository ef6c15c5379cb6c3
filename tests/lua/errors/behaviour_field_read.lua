-- expect: parts/slime has no field 'hapy'; did you mean 'happy'?
local slime = scene.add { behaviours = { ["parts/slime"] = {} } }
function update(dt) print(slime.behaviours["parts/slime"].hapy) end
