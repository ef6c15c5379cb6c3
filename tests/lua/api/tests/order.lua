-- pairs walks in a fixed order: numbers, strings, then booleans and the rest; nodes and tables by age.
local function keys(t)
  local list = {}
  for key in pairs(t) do list[#list + 1] = tostring(key) end
  return table.concat(list, " ")
end

test("strings come in the order of their bytes, however they were put in", function()
  local t = {}
  for _, word in ipairs { "pear", "apple", "fig", "Zebra", "apples" } do t[word] = true end
  expect(keys(t)):equals("Zebra apple apples fig pear")
end)

test("numbers come by size, before strings, and booleans after them", function()
  local t = { [30] = 1, [-2] = 1, [1.5] = 1, x = 1, [true] = 1, [false] = 1, [7] = 1 }
  expect(keys(t)):equals("-2 1.5 7 30 x false true")
end)

test("nodes come by age, oldest first", function()
  local a, b, c = scene.add { name = "a" }, scene.add { name = "b" }, scene.add { name = "c" }
  local t = { [c] = 1, [a] = 1, [b] = 1 }
  local names = {}
  for node in pairs(t) do names[#names + 1] = node.name end
  expect(table.concat(names, " ")):equals("a b c")
end)

test("tables and functions as keys come by age", function()
  local first, second, third = { "first" }, { "second" }, { "third" }
  local t = { [third] = 1, [first] = 1, [second] = 1 }
  local words = {}
  for key in pairs(t) do words[#words + 1] = key[1] end
  expect(table.concat(words, " ")):equals("first second third")
end)

test("entries may be changed and removed on the way", function()
  local t = {}
  for i = 1, 40 do t["key " .. i] = i end
  local seen = 0
  for key, value in pairs(t) do
    seen = seen + 1
    t[key] = value % 2 == 0 and value or nil
  end
  expect(seen):equals(40)
  local left = 0
  for _ in pairs(t) do left = left + 1 end
  expect(left):equals(20)
end)

test("next goes the same way", function()
  local t = { b = 1, a = 2, [3] = 3 }
  local key = next(t)
  expect(key):equals(3)
  expect(next(t, 3)):equals("a")
  expect(next(t, "a")):equals("b")
  expect(next(t, "b")):equals(nil)
  expect(next({})):equals(nil)
end)

test("texts show no addresses", function()
  expect(tostring({})):equals("table")
  expect(tostring(print)):equals("function")
  expect(("%s"):format({})):equals("table")
  expect(tostring(setmetatable({}, { __tostring = function() return "mine" end }))):equals("mine")
end)

test("__pairs is honoured", function()
  local t = setmetatable({}, { __pairs = function() return function(_, n) if not n then return 1, "one" end end end })
  for key, value in pairs(t) do
    expect(key):equals(1)
    expect(value):equals("one")
  end
end)
