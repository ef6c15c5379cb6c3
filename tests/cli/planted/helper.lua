return { points = 3 }
