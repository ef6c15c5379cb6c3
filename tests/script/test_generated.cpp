// The documents and editor types are what the table gives, and the table is what a running game has.
#include <catch2/catch.hpp>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "script/document.h"
#include "support/source_tree.h"
#include "support/test_game.h"

using namespace tumble;

namespace {

using Files = std::map<std::string, std::string>;
using NameSet = std::set<std::string>;
using What = DocumentedName::Kind;

NameSet names_of(const std::string& area, bool object, What kind) {
  NameSet names;
  for (const DocumentedName& entry : documented_names())
    if (entry.area == area && entry.object == object && entry.kind == kind) names.insert(entry.name);
  return names;
}

NameSet matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  NameSet names;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) names.insert((*at)[1]);
  return names;
}

// The names in a list of scripts/boot/names.lua: names.node_events = { "on_collision_enter", ... }.
NameSet boot_list(const std::string& list) {
  const std::string text = read_source(source_tree("scripts/boot/names.lua"));
  const std::size_t begin = text.find("names." + list + " = {");
  REQUIRE(begin != std::string::npos);
  return matches(text.substr(begin, text.find('}', begin) - begin), "\"([a-z_]+)\"");
}

NameSet joined(std::initializer_list<NameSet> lists) {
  NameSet all;
  for (const NameSet& list : lists) all.insert(list.begin(), list.end());
  return all;
}

// ---- a game with one of everything, and an expression for each

const std::map<std::string, std::string> kSamples = {
    {"node", "ball"},         {"mesh", "ball.mesh"},  {"material", "ball.material"}, {"light", "lamp.light"},    {"camera", "eye.camera"},
    {"sky", "lamp.sky"},      {"sound", "lamp.sound"}, {"particles", "lamp.particles"}, {"animation", "lamp.animation"},
    {"body", "ball.body"},    {"joint", "hinge"},     {"vec3", "vec3.up"},           {"quat", "quat.identity"},  {"color", "ball.color"},
    {"hit", "last_hit"},      {"task", "a_task"},     {"behaviour", "behaviour_of_ball"}, {"voice", "a_voice"}};

const char* const kGame = R"(
local floor = scene.add { name = "floor", mesh = { shape = "box", size = vec3(9, 1, 9) }, body = "static" }
local ball = scene.add { name = "ball", position = vec3(0, 3, 0), mesh = "sphere", material = "red", body = "dynamic", behaviours = { thing = {} } }
local rod = scene.add { name = "rod", position = vec3(2, 3, 0), mesh = "box", body = "dynamic" }
local lamp = scene.add { name = "lamp", light = "sun", sky = {}, sound = {}, particles = {}, animation = {} }
local eye = scene.add { name = "eye", position = vec3(0, 2, 9), camera = {} }
local hinge = joint.hinge { name = "hinge", a = rod }
local slider = joint.slider { name = "slider", a = ball }
local last_hit, a_task, behaviour_of_ball, a_voice

local function check(name, kind, get)
  local ok, value = pcall(get)
  if not ok then print(name .. ": " .. tostring(value))
  elseif kind and type(value) ~= kind then print(name .. " is " .. type(value)) end
end

function update()
  if time.tick ~= 2 then return end
  last_hit = physics.raycast(vec3(0, 9, 0), vec3.down, 20)
  a_task = task.after(9, function() end)
  behaviour_of_ball = ball.behaviours.thing
  a_voice = sound.play("none.wav")
)";

std::string line(const std::string& expression, const std::string& kind) {
  return "  check('" + expression + "', " + (kind.empty() ? "nil" : "'" + kind + "'") + ", function() return " + expression + " end)\n";
}

// A line that tries one function, property or field; none for events and what only bots have.
std::string line_for(const DocumentedName& entry) {
  if (entry.kind == What::event || entry.area == "bot") return "";
  const std::string kind = entry.kind == What::function ? "function" : "";
  if (entry.area == "globals") return line(entry.name, kind);
  if (!entry.object) return line(entry.area + "." + entry.name, kind);
  const std::string sample = entry.area == "joint" && entry.name == "position" ? "slider" : kSamples.at(entry.area);
  return line(sample + "." + entry.name, kind);
}

}  // namespace

TEST_CASE("generated: the committed documents and types are what the table gives", "[script][generated]") {
  for (const auto& [path, text] : document_files()) {
    INFO(path << " differs; run `./tumble docs` and commit it");
    REQUIRE(std::filesystem::exists(source_tree(path)));
    CHECK((read_source(source_tree(path)) == text));
  }
}

TEST_CASE("generated: no document is left over", "[script][generated]") {
  NameSet known;
  for (const auto& [path, text] : document_files()) known.insert(path);

  for (const char* folder : {"docs/api", "scripts/types"})
    for (const auto& entry : std::filesystem::directory_iterator(source_tree(folder))) {
      const std::string path = std::filesystem::relative(entry.path(), source_tree()).generic_string();
      INFO(path);
      CHECK(known.count(path) == 1);
    }
}

TEST_CASE("generated: the documents are the same at every call", "[script][generated]") { CHECK(document_files() == document_files()); }

TEST_CASE("generated: a running game has every name in the table", "[script][generated]") {
  std::string text = kGame;
  for (const DocumentedName& entry : documented_names()) text += line_for(entry);
  TestGame game({{"main.lua", text + "  game.report.walked = 1\nend\n"}, {"thing.lua", "return behaviour {}\n"}});

  game.tick(4);

  CHECK(game.last_error() == "");
  CHECK(game.printed() == "");
  CHECK(game.number("walked") == 1);
}

TEST_CASE("generated: a running game has no global name that is in no document", "[script][generated]") {
  TestGame game(Files{{"main.lua", "for name in pairs(_ENV) do print(name) end\n"}});
  NameSet known = {"assert", "error", "ipairs", "pairs", "next", "pcall", "xpcall", "select", "tonumber", "tostring", "type", "setmetatable",
                 "getmetatable", "rawequal", "rawget", "rawlen", "coroutine", "string", "table", "utf8", "host"};
  for (const DocumentedName& entry : documented_names()) {
    if (entry.area == "globals") known.insert(entry.name);
    else if (!entry.object && entry.area != "handlers" && entry.area != "bot" && entry.area.find('.') == std::string::npos) known.insert(entry.area);
  }

  NameSet found;
  std::istringstream printed(game.printed());
  for (std::string name; std::getline(printed, name);) found.insert(name);

  CHECK(game.last_error() == "");
  CHECK(found == known);
}

TEST_CASE("generated: the events in the documents are those that boot calls", "[script][generated]") {
  const NameSet phases = boot_list("phases"), input = boot_list("input_events"), on_nodes = boot_list("node_events");

  CHECK(names_of("node", true, What::event) == joined({on_nodes, {"update"}}));
  CHECK(names_of("handlers", false, What::event) == joined({phases, input, boot_list("file_events")}));
  CHECK(names_of("behaviour", true, What::event) == joined({phases, input, on_nodes, boot_list("behaviour_events")}));
}

TEST_CASE("generated: the verbs of bots and tasks are those that boot provides", "[script][generated]") {
  const std::string bot = read_source(source_tree("scripts/boot/bot.lua")), tasks = read_source(source_tree("scripts/boot/tasks.lua"));

  CHECK(names_of("bot", false, What::function) == joined({matches(bot, "function verbs\\.([a-z_]+)"), {"test", "expect"}}));
  CHECK(names_of("task", true, What::function) == matches(tasks, "function methods\\.([a-z_]+)"));
}
