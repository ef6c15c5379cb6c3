-- expect: sound.music: not at the top level of a file, which runs again at every save; put it in start()
sound.music("tune.ogg")
