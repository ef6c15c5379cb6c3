-- expect: require: 'parts/slime' must be asked for at the top of a file, not in a function
function start() require "parts/slime" end
