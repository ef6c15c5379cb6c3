-- expect: particles:burst: not at the top level of a file, which runs again at every save; put it in start()
local spark = scene.add { particles = { color = "gold" } }
spark.particles:burst(10)
