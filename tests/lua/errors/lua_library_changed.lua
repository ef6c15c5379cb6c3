-- expect: 'math' belongs to Lua and cannot be changed
math.pi = 3
