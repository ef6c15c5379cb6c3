-- expect: math has no 'randomseed'
math.randomseed(3)
