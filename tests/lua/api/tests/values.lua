-- vec3, quat, color and what math has beside Lua's own: truth comes from formulas.
local function sample()              -- a few vectors without symmetry
  return { vec3(1, 2, 3), vec3(-4, 0.5, 2), vec3(0.1, -7, 0.3), vec3(5, 5, -5) }
end

test("vec3: the components are what was given", function()
  local v = vec3(1.5, -2, 3)
  expect(v.x):equals(1.5)
  expect(v.y):equals(-2)
  expect(v.z):equals(3)
  local x, y, z = v:unpack()
  expect(x):equals(1.5)
  expect(y):equals(-2)
  expect(z):equals(3)
end)

test("vec3: equal means component by component, and exactly", function()
  expect(vec3(1, 2, 3) == vec3(1, 2, 3)):equals(true)
  expect(vec3(1, 2, 3) == vec3(1, 2, 3.0000001)):equals(false)
  expect(vec3(1, 2, 3) == 1):equals(false)
  expect(vec3(0, 0, 0) == vec3(-0.0, 0, 0)):equals(true)
end)

test("vec3: plus and minus undo each other", function()
  for _, v in ipairs(sample()) do
    for _, w in ipairs(sample()) do expect((v + w) - w):near(v, 1e-12) end
  end
end)

test("vec3: a number scales, a vector multiplies per component", function()
  expect(vec3(1, 2, 3) * 2):equals(vec3(2, 4, 6))
  expect(2 * vec3(1, 2, 3)):equals(vec3(2, 4, 6))
  expect(vec3(1, 2, 3) * vec3(2, 3, 4)):equals(vec3(2, 6, 12))
  expect(vec3(2, 4, 6) / 2):equals(vec3(1, 2, 3))
  expect(vec3(2, 6, 12) / vec3(2, 3, 4)):equals(vec3(1, 2, 3))
  expect(-vec3(1, -2, 3)):equals(vec3(-1, 2, -3))
end)

test("vec3: the length is Pythagoras's", function()
  expect(vec3(3, 4, 12):length()):equals(13)
  expect(vec3(1, 2, 3):distance(vec3(4, 6, 15))):equals(13)
  expect(vec3.zero:length()):equals(0)
end)

test("vec3: cross stands on both, and its length is |v| |w| sin", function()
  for _, v in ipairs(sample()) do
    for _, w in ipairs(sample()) do
      local c = v:cross(w)
      expect(c:dot(v)):near(0, 1e-9)
      expect(c:dot(w)):near(0, 1e-9)
      expect(c:length()):near(v:length() * w:length() * math.sin(v:angle(w)), 1e-9)
      expect(v:dot(w)):near(v:length() * w:length() * math.cos(v:angle(w)), 1e-9)
    end
  end
  expect(vec3.right:cross(vec3.up)):equals(vec3.back)       -- right-handed
end)

test("vec3: normalized has length 1, and zero stays zero", function()
  for _, v in ipairs(sample()) do
    expect(v:normalized():length()):near(1, 1e-12)
    expect(v:normalized():angle(v)):near(0, 1e-7)
  end
  expect(vec3.zero:normalized()):equals(vec3.zero)
end)

test("vec3: clamped shortens what is too long and leaves the rest", function()
  expect(vec3(0, 10, 0):clamped(3)):equals(vec3(0, 3, 0))
  expect(vec3(0, 2, 0):clamped(3)):equals(vec3(0, 2, 0))
end)

test("vec3: lerp, with_x, with_y, with_z", function()
  expect(vec3(0, 0, 0):lerp(vec3(4, 8, -4), 0.25)):equals(vec3(1, 2, -1))
  expect(vec3(1, 2, 3):with_x(9)):equals(vec3(9, 2, 3))
  expect(vec3(1, 2, 3):with_y(9)):equals(vec3(1, 9, 3))
  expect(vec3(1, 2, 3):with_z(9)):equals(vec3(1, 2, 9))
end)

test("vec3: the named ones", function()
  expect(vec3.one):equals(vec3(1, 1, 1))
  expect(vec3.up + vec3.down):equals(vec3.zero)
  expect(vec3.left + vec3.right):equals(vec3.zero)
  expect(vec3.forward):equals(vec3(0, 0, -1))
  expect(vec3.back):equals(vec3(0, 0, 1))
end)

test("vec3: nothing can be written", function()
  local v = vec3(1, 2, 3)
  expect(function() v.x = 5 end):raises("vec3 values do not change")
  expect(function() vec3.up = v end):raises("cannot be changed")
  expect(v):equals(vec3(1, 2, 3))
end)

test("vec3: its text shows its numbers", function()
  expect(tostring(vec3(1, 2.5, -3))):contains("2.5")
end)

test("quat: an axis and an angle turn as Rodrigues says", function()
  local axis = vec3(1, 2, -0.5):normalized()
  for _, angle in ipairs { 0.3, 1, 2.5, -1.2 } do
    local q = quat.axis_angle(axis, angle)
    for _, v in ipairs(sample()) do
      local c, s = math.cos(angle), math.sin(angle)
      local turned = v * c + axis:cross(v) * s + axis * (axis:dot(v) * (1 - c))
      expect(q * v):near(turned, 1e-9)
      expect(v:rotated(q)):near(turned, 1e-9)
    end
  end
end)

test("quat: turning goes by the right hand", function()
  expect(quat.axis_angle(vec3.up, math.pi / 2) * vec3.forward):near(vec3.left, 1e-12)
  expect(quat.axis_angle(vec3.right, math.pi / 2) * vec3.up):near(vec3.back, 1e-12)
end)

test("quat: a product turns by the right one first, and the inverse turns back", function()
  local q, r = quat.axis_angle(vec3.up, 0.7), quat.axis_angle(vec3.right, -1.1)
  for _, v in ipairs(sample()) do
    expect((q * r) * v):near(q * (r * v), 1e-9)
    expect(q:inverse() * (q * v)):near(v, 1e-9)
    expect(quat.identity * v):equals(v)
  end
end)

test("quat: Euler angles turn about y first, then x, then z, each about the node's own axes", function()
  local x, y, z = 20, 50, -70
  local by_hand = quat.axis_angle(vec3.up, math.rad(y)) * quat.axis_angle(vec3.right, math.rad(x)) * quat.axis_angle(vec3.back, math.rad(z))
  for _, v in ipairs(sample()) do expect(quat.euler_degrees(x, y, z) * v):near(by_hand * v, 1e-9) end
end)

test("quat: look points forward there and keeps up above", function()
  local there = vec3(1, 0.5, -2)
  local q = quat.look(there)
  expect(q * vec3.forward):near(there:normalized(), 1e-9)
  expect((q * vec3.right).y):near(0, 1e-9)
  expect((q * vec3.up).y):above(0)
end)

test("quat: slerp turns evenly", function()
  local q = quat.identity:slerp(quat.axis_angle(vec3.up, 1.6), 0.25)
  expect(q * vec3.right):near(quat.axis_angle(vec3.up, 0.4) * vec3.right, 1e-9)
end)

test("color: names, hex and numbers mean the same", function()
  expect(color "red" == color(1, 0, 0)):equals(true)
  expect(color "#00f" == color(0, 0, 1)):equals(true)
  expect(color "#0000ff" == color(0, 0, 1)):equals(true)
  expect(color "orange".r):equals(1)
  expect(color "orange".g):near(165 / 255, 1e-6)
  expect(color "orange".b):equals(0)
  expect(color(0.2, 0.4, 0.6).a):equals(1)
end)

test("color: hsv goes round the wheel", function()
  for i, name in ipairs { "red", "yellow", "lime", "cyan", "blue", "magenta" } do
    local made, named = color.hsv((i - 1) / 6, 1, 1), color(name)
    for _, part in ipairs { "r", "g", "b" } do expect(made[part]):near(named[part], 1e-6) end
  end
  expect(color.hsv(0.3, 0, 0.5).g):near(0.5, 1e-9)
end)

test("color: lerp and with_alpha", function()
  local half = color "black":lerp(color "white", 0.5)
  expect(half.r):near(0.5, 1e-9)
  expect(color "red":with_alpha(0.25).a):equals(0.25)
end)

test("math: clamp, lerp, round, sign, approach", function()
  expect(math.clamp(5, 0, 3)):equals(3)
  expect(math.clamp(-5, 0, 3)):equals(0)
  expect(math.clamp(2, 0, 3)):equals(2)
  expect(math.lerp(10, 20, 0.25)):equals(12.5)
  expect(math.round(2.5)):equals(3)
  expect(math.round(-2.5)):equals(-3)
  expect(math.round(2.4)):equals(2)
  expect(math.sign(-0.1)):equals(-1)
  expect(math.sign(0)):equals(0)
  expect(math.approach(1, 5, 3)):equals(4)
  expect(math.approach(1, 5, 30)):equals(5)
  expect(math.approach(5, 1, 3)):equals(2)
end)
