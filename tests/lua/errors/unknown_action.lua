-- expect: input.bind: 
function start() input.bind("jump", { "spcae" }) end
