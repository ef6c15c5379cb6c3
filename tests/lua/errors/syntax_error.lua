-- expect: 'then' expected near 'print'
if 1 < 2 print("small") end
