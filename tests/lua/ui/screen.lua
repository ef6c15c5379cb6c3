-- What the tests put on the screen: they set draw, and read what the game was told.
return { draw = nil, heard = {}, values = {} }
