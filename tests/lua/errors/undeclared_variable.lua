-- expect: 'score' is not declared; write `local score = 1` at the top of the file
score = 1
