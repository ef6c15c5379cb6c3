-- expect: unknown name 'os'
print(os.time())
