-- Watch: fire, smoke, a fountain and snow are the same thing with other numbers. Change one and save.
scene.add { name = "camera", position = vec3(0, 2.2, 8), rotation_degrees = vec3(-6, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "dimgray", mesh = { shape = "box", size = vec3(14, 0.2, 8) } }

-- Small and slow, from a little box; glow is light of its own, and color_end without opacity fades it out.
scene.add { name = "fire", position = vec3(-3, 0.1, 0), particles = { rate = 80, life = 1.1, speed = 1.6, spread_degrees = 12,
  area = vec3(0.5, 0, 0.5), size = 0.45, size_end = 0.1, color = "orange", color_end = color(1, 0.1, 0, 0), glow = 2 } }
-- Smoke grows, and the air (damping) stops it.
scene.add { name = "smoke", position = vec3(-3, 1, 0), particles = { rate = 12, life = 4, speed = 1.5, damping = 0.4,
  spread_degrees = 18, size = 0.4, size_end = 1.5, color = color(0.35, 0.35, 0.35, 0.5), color_end = color(0.6, 0.6, 0.6, 0) } }
-- Water falls: gravity_factor 1 is the world's own gravity, so 7 m/s rise to 2.5 m.
scene.add { name = "fountain", position = vec3(0, 0.1, 0), particles = { rate = 250, life = 1.45, speed = 7, spread_degrees = 9,
  gravity_factor = 1, size = 0.09, size_end = 0.05, color = "lightskyblue", color_end = "white" } }
-- Snow begins in a wide, flat box and sinks with the speed at which the air holds it: 9.81 * 0.1 / damping.
scene.add { name = "snow", position = vec3(3, 4, 0), particles = { rate = 60, life = 4, speed = 0, gravity_factor = 0.1, damping = 1,
  area = vec3(3, 0, 3), size = 0.07, size_end = 0.07, color = "white", color_end = "white" } }
