-- expect: input.bind: no key or button 'spcae'; did you mean 'space'?
function start() input.bind("jump", { "spcae" }) end
