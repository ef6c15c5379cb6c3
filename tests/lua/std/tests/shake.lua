-- scripts/std/shake.
test("shake: it moves at most so far, dies down in its time and ends where it began", function()
  local node = scene.add { name = "camera", position = vec3(1, 2, 3), rotation_degrees = vec3(10, 20, 0),
    behaviours = { shake = { distance = 0.5, seconds = 1 } } }
  wait(0.1)
  local home, rotation = node.position, node.rotation
  expect(node:send("shake", 1)):equals(true)
  local farthest = 0
  for _ = 1, 58 do
    wait(0)
    farthest = math.max(farthest, node.position:distance(home))
  end
  expect(farthest):above(0.05)
  expect(farthest):below(0.5 * math.sqrt(2))        -- two waves of at most 1
  wait(0.2)
  expect(node.position):equals(home)
  expect(node.rotation * vec3.one):near(rotation * vec3.one, 1e-12)   -- a rotation is made of length 1 when it is set
end)
