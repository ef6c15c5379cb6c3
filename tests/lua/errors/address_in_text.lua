-- expect: string.format: %p shows addresses, which differ in every run; use %s
print(string.format("%p", {}))
