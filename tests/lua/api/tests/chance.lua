-- Random numbers: in range, evenly spread, and the same in every run of the same seed.
test("math.random and random.between stay in their range and fill it", function()
  local low, high, sum = math.huge, -math.huge, 0
  for _ = 1, 2000 do
    local n = random.between(-2, 3)
    low, high, sum = math.min(low, n), math.max(high, n), sum + n
  end
  expect(low):above(-2 - 1e-12)
  expect(high):below(3)
  expect(low):below(-1.9)
  expect(high):above(2.9)
  expect(sum / 2000):near(0.5, 0.13)                        -- four standard errors: 5 / sqrt(12 * 2000) each
end)

test("math.random(n) gives whole numbers from 1 to n, all of them", function()
  local counts = {}
  for _ = 1, 600 do
    local n = math.random(6)
    counts[n] = (counts[n] or 0) + 1
  end
  expect(#counts):equals(6)
  for i = 1, 6 do expect(counts[i]):near(100, 40) end
  local n = math.random(3, 4)
  expect(n == 3 or n == 4):equals(true)
end)

test("choice takes only what is in the list, shuffle keeps it all", function()
  local list = { "a", "b", "c", "d", "e" }
  for _ = 1, 50 do expect(list):contains(random.choice(list)) end
  local mixed = random.shuffle({ "a", "b", "c", "d", "e" })
  expect(#mixed):equals(5)
  for _, letter in ipairs(list) do expect(mixed):contains(letter) end
end)

test("chance(p) is true p of the time", function()
  local count = 0
  for _ = 1, 2000 do if random.chance(0.3) then count = count + 1 end end
  expect(count / 2000):near(0.3, 0.041)                     -- four standard errors
  expect(random.chance(0)):equals(false)
  expect(random.chance(1)):equals(true)
end)

test("directions have length 1 and no favourite; points in a sphere stay inside", function()
  local sum = vec3.zero
  for _ = 1, 2000 do
    local d = random.direction()
    expect(d:length()):near(1, 1e-9)
    sum = sum + d
    expect(random.in_sphere(3):length()):below(3 + 1e-9)
  end
  expect((sum / 2000):length()):below(0.08)
end)
