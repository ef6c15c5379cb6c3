-- expect: scene.send: not at the top level of a file, which runs again at every save; put it in start()
scene.send("begin")
