-- expect: task.after: not at the top level of a file, which runs again at every save; put it in start()
task.after(1, print)
