-- expect: random.choice: a list with at least one entry expected
function start() random.choice({}) end
