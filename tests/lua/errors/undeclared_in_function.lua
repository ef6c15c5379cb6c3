-- expect: 'score' is not declared; write `local score = 5` at the top of the file
function update(dt)
  score = 5
end
