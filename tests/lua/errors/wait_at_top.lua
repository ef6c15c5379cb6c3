-- expect: wait: works only in a task
wait(1)
