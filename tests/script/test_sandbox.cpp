// What scripts cannot do, and what is the same in every run.
#include <catch2/catch.hpp>

#include "support/test_game.h"

using namespace tumble;

TEST_CASE("sandbox: nothing that reaches outside the game is there", "[sandbox]") {
  for (const char* name : {"os", "io", "debug", "package", "load", "loadstring", "dofile", "loadfile", "collectgarbage", "rawset"}) {
    TestGame game(Files{{"main.lua", std::string("local x = ") + name + "\n"}});
    INFO(name);
    CHECK_FALSE(game.started);
    CHECK(game.last_error().find(std::string("unknown name '") + name + "'") != std::string::npos);
  }
  TestGame dump(Files{{"main.lua", "local x = string.dump\n"}});
  CHECK_FALSE(dump.started);
}

TEST_CASE("sandbox: a loop without an end is stopped after the limit, and pcall does not hide it", "[sandbox]") {
  TestGame game(Files{{"main.lua", "function update() pcall(function() while true do end end) while true do pcall(error) end end\nfunction late_update() game.report.alive = time.tick end\n"}}, 0.2);

  game.tick(2);

  REQUIRE(game.failures.size() == 1);
  CHECK(game.last_error().find("is a loop without an end in it?") != std::string::npos);
  CHECK(game.failures[0].line == 1);
  CHECK(game.number("alive") == 2);
}

TEST_CASE("sandbox: a loop without an end in a task is stopped too", "[sandbox]") {
  TestGame game(Files{{"main.lua", "function start() task.spawn(function() wait(0) while true do end end) end\n"}}, 0.2);

  game.tick(3);

  CHECK(game.failures.size() == 1);
  CHECK(game.last_error().find("loop without an end") != std::string::npos);
}

TEST_CASE("sandbox: pairs walks numbers, then strings, then nodes by age", "[sandbox]") {
  const std::string text = R"(
local a, b, c = scene.add { name = "a" }, scene.add { name = "b" }, scene.add { name = "c" }
local t1, t2 = {}, {}
function start()
  local t = { [c] = 1, z = 1, [a] = 1, y = 1, [10] = 1, [2.5] = 1, x = 1, [true] = 1, [b] = 1, [false] = 1, [-3] = 1 }
  local seen = {}
  for key in pairs(t) do seen[#seen + 1] = tostring(key) end
  print(table.concat(seen, " "))
  local objects, order = { [t2] = "second", [t1] = "first" }, {}
  for _, name in pairs(objects) do order[#order + 1] = name end
  print(table.concat(order, " "))
  local key, list = nil, {}
  repeat
    key = next(t, key)
    if key ~= nil then list[#list + 1] = tostring(key) end
  until key == nil
  print(table.concat(list, " ") == table.concat(seen, " "))
end
)";
  TestGame game(Files{{"main.lua", text}});

  CHECK(game.last_error() == "");
  CHECK(game.printed() == "-3 2.5 10 x y z false true node 'a' node 'b' node 'c'\nfirst second\ntrue\n");
}

TEST_CASE("sandbox: pairs walks vec3, bodies, functions and coroutines oldest first", "[sandbox]") {
  const std::string text = R"(
local a = scene.add { name = "a", mesh = "box", body = {} }
local b = scene.add { name = "b", mesh = "box", body = {} }
local function f() end
local function g() end
function start()
  local v, w = vec3(2, 0, 0), vec3(1, 0, 0)
  local c, d = coroutine.create(f), coroutine.create(g)
  local names = { [w] = "w", [v] = "v", [b.body] = "b", [a.body] = "a", [g] = "g", [f] = "f", [d] = "d", [c] = "c" }
  local order = {}
  for _, name in pairs(names) do order[#order + 1] = name end
  print(table.concat(order))
end
)";
  TestGame game(Files{{"main.lua", text}});

  CHECK(game.last_error() == "");
  CHECK(game.printed() == "vwabfgcd\n");
}

TEST_CASE("sandbox: no address shows in any text", "[sandbox]") {
  TestGame game(Files{{"main.lua", "function start() print({}, print, coroutine.create(print), ('%s'):format({})) end\n"}});

  CHECK(game.printed().find("0x") == std::string::npos);
  CHECK(game.printed() == "table\tfunction\tthread\ttable\n");
}

TEST_CASE("frame: it draws and cannot change the world", "[sandbox]") {
  TestGame game(Files{{"main.lua", "local n = scene.add { name = 'n' }\nfunction frame() n.position = vec3(1, 0, 0) end\n"}});

  game.frame();

  CHECK(game.position("n") == Vec3{0, 0, 0});
  CHECK(game.last_error() == "main.lua:2: node.position: frame only draws; change things in update or late_update");
}

TEST_CASE("frame: a local or a field that it changes is put back, with a sentence", "[sandbox]") {
  TestGame local(Files{{"main.lua", "local n = 0\nfunction frame() n = n + 1 end\nfunction update() game.report.n = n end\n"}});
  local.frame();
  local.tick(1);
  CHECK(local.number("n") == 0);
  CHECK(local.last_error().find("main.lua: frame changed the local 'n'") == 0);

  TestGame field(Files{{"main.lua", "scene.add { behaviours = { b = {} } }"},
                       {"b.lua", "local B = behaviour { n = 0 }\nfunction B:frame() self.n = self.n + 1 end\nfunction B:update() game.report.n = self.n end\nreturn B\n"}});
  field.tick(1);
  field.frame();
  field.tick(1);
  CHECK(field.number("n") == 0);
  CHECK(field.last_error().find("b.lua: frame changed the field 'n'") == 0);
}

TEST_CASE("frame: an entry of a table that it changes is put back, with a sentence", "[sandbox]") {
  TestGame game(Files{{"main.lua", "local t = { deep = { n = 1 } }\nfunction frame() t.deep.n = 2 t.new = true setmetatable(t, { __index = t }) end\n"
                                   "function update() game.report.n = t.deep.n game.report.new = t.new and 1 or 0 end\n"}});

  game.frame();
  game.tick(1);

  CHECK(game.number("n") == 1);
  CHECK(game.number("new") == 0);
  CHECK(game.last_error().find("frame changed") == 0);
}

TEST_CASE("memory: scripts that want more than their limit get a sentence and the game goes on", "[sandbox]") {
  TestGame game(Files{{"main.lua", "function update() local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end end\nfunction late_update() game.report.n = time.tick end\n"}}, 30);

  game.tick(2);

  CHECK(game.failures.size() == 1);
  CHECK(game.last_error().find("need more memory") != std::string::npos);
  CHECK(game.number("n") == 2);
}

TEST_CASE("hash: the same game, seed and input give the same hash; another seed another", "[sandbox]") {
  const std::string text = "function update() scene.add { name = 'n', position = random.in_sphere(3) } end\n";
  auto run = [&](std::uint64_t seed, int frames) {
    TestGame game(Files{{"main.lua", text + "function frame() random.between(0, 1) end\n"}}, 1, seed);
    for (int i = 0; i < 20; ++i) {
      game.tick(1);
      for (int k = 0; k < frames; ++k) game.frame();
    }
    return game.script->hash();
  };

  CHECK(run(1, 0) == run(1, 0));
  CHECK(run(1, 0) == run(1, 3));
  CHECK(run(1, 0) != run(2, 0));
}

TEST_CASE("errors: the way to one names the author's lines and nothing else", "[sandbox]") {
  TestGame direct(Files{{"main.lua", "local x = nil + 1\n"}});
  REQUIRE(direct.failures.size() == 1);
  CHECK(direct.failures[0].traceback.empty());  // it would only repeat the line

  TestGame called(Files{{"main.lua", "local function f(x)\n  return x.y.z\nend\nf({})\n"}});
  REQUIRE(called.failures.size() == 1);
  const std::string& way = called.failures[0].traceback;
  CHECK(way.find("main.lua:2: in ") != std::string::npos);
  CHECK(way.find("main.lua:4: in the file itself") != std::string::npos);
  CHECK(way.find("chunk") == std::string::npos);
}
