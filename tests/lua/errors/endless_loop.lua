-- expect: stopped: it ran for more than
function start() while true do end end
