-- expect: put it in start()
pcall(game.finish)
