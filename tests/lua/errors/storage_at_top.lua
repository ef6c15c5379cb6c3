-- expect: storage.save: not at the top level of a file, which runs again at every save; put it in start()
storage.save("best", 3)
