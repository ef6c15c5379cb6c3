-- expect: input.bind: no field 'saved'; did you mean 'save'?
function start() input.bind("jump", { "k" }, { saved = true }) end
