-- expect: the scripts need more memory than the
function start() string.rep("x", 1 << 30) end
