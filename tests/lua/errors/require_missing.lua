-- expect: require: no file 'parts/slme.lua' in the game or in scripts/std; did you mean 'parts/slime'?
require "parts/slme"
