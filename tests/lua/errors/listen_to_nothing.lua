-- expect: input.listen: fn: function expected, got nil
function start() input.listen() end
