-- expect: send: nobody handles 'hrut'; did you mean 'hurt'?
function on_hurt(amount) end
function start() scene.send("hrut", 3) end
