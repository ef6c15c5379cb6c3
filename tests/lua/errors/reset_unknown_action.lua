-- expect: input.reset_bindings: no action 'jump' in game.json
function start() input.reset_bindings("jump") end
