-- expect: unknown name 'debug'
debug.getinfo(1)
