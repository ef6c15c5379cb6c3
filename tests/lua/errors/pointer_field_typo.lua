-- expect: input.pointer has no 'capture'; did you mean 'captured'?
function start() input.pointer.capture = true end
