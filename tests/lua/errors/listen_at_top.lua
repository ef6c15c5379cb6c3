-- expect: input.listen: not at the top level of a file
input.listen(function(name) print(name) end)
