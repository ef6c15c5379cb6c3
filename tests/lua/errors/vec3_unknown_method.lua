-- expect: has no 'lenght'; did you mean 'length'?
print(vec3.up:lenght())
