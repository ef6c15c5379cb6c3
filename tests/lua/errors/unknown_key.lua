-- expect: input.is_down: unknown name 'spcae'; did you mean 'space'?
function update(dt) if input.is_down("spcae") then print("up") end end
