-- expect: input.is_down: not at the top level of a file, which runs again at every save; put it in start()
local fast = input.is_down("space")
