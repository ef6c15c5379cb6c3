-- expect: input.rumble: strength: 0 to 1 expected, got 3
function start() input.rumble(3, 1) end
