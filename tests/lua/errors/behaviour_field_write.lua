-- expect: parts/slime has no field 'hapy'; did you mean 'happy'?
local slime = scene.add { behaviours = { ["parts/slime"] = {} } }
function update(dt) slime.behaviours["parts/slime"].hapy = false end
