-- expect: unknown name 'io'
io.open("main.lua")
