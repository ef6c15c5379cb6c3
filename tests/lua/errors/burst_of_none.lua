-- expect: particles:burst: count: 1 to 20000 expected, got 0
local spark = scene.add { particles = "gold" }
function update() spark.particles:burst(0) end
