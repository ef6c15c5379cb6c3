-- Storage: values by key, copied both ways. A test begins with nothing stored.
test("nothing is stored at first, and the default is given", function()
  expect(storage.load("best")):equals(nil)
  expect(storage.load("best", 7)):equals(7)
  expect(storage.load("best", false)):equals(false)
end)

test("what is saved is loaded at once, each value of its kind", function()
  local saved = { score = 3, time = 2.0, name = "Zoë", done = true, at = vec3(1, 2, 3), paint = color("orange"), list = { 1, { 2 } }, none = {} }
  storage.save("all", saved)
  local loaded = storage.load("all")
  expect(loaded):equals(saved)
  expect(math.type(loaded.score)):equals("integer")
  expect(math.type(loaded.time)):equals("float")
  expect(loaded.at + vec3.up):equals(vec3(1, 3, 3))
  storage.save("done", false)
  expect(storage.load("done", true)):equals(false)
end)

test("saving and loading copy", function()
  local scores, first = { 1, 2 }, { 9 }
  storage.save("scores", scores)
  scores[1] = 100
  storage.load("scores")[2] = 200
  expect(storage.load("scores")):equals({ 1, 2 })
  storage.load("missing", first)[1] = 0
  expect(first[1]):equals(9)
end)

test("nil removes a key", function()
  storage.save("best", 3)
  storage.save("best", nil)
  expect(storage.load("best")):equals(nil)
end)

test("a mistake leaves what was stored", function()
  storage.save("best", 3)
  expect(function() storage.save("best", { print }) end):raises("a function cannot be stored")
  expect(function() storage.save("best", { scene.root }) end):raises("storage.save: best[1]: a node cannot be stored; store its name or its position")
  expect(function() storage.save("best", 1 / 0) end):raises("a finite number expected")
  expect(function() storage.save("best") end):raises("argument 2 (value): value expected")
  expect(function() storage.save("best", ("x"):rep(2000000)) end):raises("store less")
  expect(storage.load("best")):equals(3)
end)
