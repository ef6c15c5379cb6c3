// Who may include whom. Headers in /usr/include are found without being asked for, so the build alone would not notice.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "support/source_tree.h"

using namespace tumble;

namespace {

using Words = std::vector<std::string>;

// A folder of runtime/ -> the folders whose headers it may include, beside its own.
const std::map<std::string, Words> kMayUse = {
    {"base", {}},
    {"assets", {"base"}},
    {"scene", {"base"}},
    {"physics", {"base"}},
    {"platform", {"base"}},
    {"render", {"base", "assets", "platform"}},
    {"engine", {"base", "scene", "physics", "assets", "render", "platform"}},
    {"script", {"base", "scene", "physics", "assets", "render", "platform", "engine"}},
    {"app", {"base", "scene", "physics", "assets", "render", "platform", "engine", "script"}},
    {"cli", {}},
    {"include", {}},
};

struct ThirdParty {
  const char* headers;  // matches the start of what stands between the brackets
  const char* places;   // matches the paths that may include them
  const char* name;
};
const ThirdParty kThirdParty[] = {
    {R"(lua|lauxlib|lualib)", R"(runtime/script/.*)", "Lua"},
    {R"(bt[A-Z]|Bullet|LinearMath)", R"(runtime/physics/bullet/.*)", "Bullet"},
    {R"(SDL)", R"(runtime/platform/sdl/.*|runtime/(platform|render/gl)/.*\.cpp)", "SDL"},
    {R"(GL/|GLES|EGL/|KHR/)", R"(runtime/(render/gl|platform/sdl)/.*)", "OpenGL"},
    {R"(nlohmann/)", R"(runtime/engine/json\.cpp)", "nlohmann's JSON"},
    {R"(Eigen/)", R"(runtime/(physics|render)/.*)", "Eigen"},
    {R"(zip)", R"(runtime/assets/.*\.cpp)", "libzip"},
    {R"(zlib)", R"(runtime/render/picture\.cpp)", "zlib"},
    {R"((vorbis|ogg)/)", R"(runtime/assets/.*\.cpp)", "libvorbis"},
    {R"(tiny_gltf)", R"(runtime/assets/gltf.*\.cpp)", "tinygltf"},
    {R"(stb)", R"(runtime/(assets|render)/.*\.cpp)", "stb"},
    {R"(CLI/)", R"(runtime/cli/.*)", "CLI11"},
};

// "runtime/scene/node.h" -> "scene".
std::string folder_of(const std::string& path) {
  const std::size_t begin = path.find('/') + 1;
  return path.substr(begin, path.find('/', begin) - begin);
}

// What is wrong with one include, or "".
std::string fault(const std::string& path, bool ours, const std::string& header) {
  if (ours) {
    const std::string from = folder_of(path), to = header.substr(0, header.find('/'));
    if (header == "tumble/tumble.h" || to == from) return "";
    const auto known = kMayUse.find(from);
    if (known == kMayUse.end()) return "the folder " + from + " is not in the table of this test";
    const Words& may = known->second;
    return std::find(may.begin(), may.end(), to) == may.end() ? from + " may not use " + to : "";
  }
  for (const ThirdParty& party : kThirdParty)
    if (std::regex_search(header, std::regex("^(" + std::string(party.headers) + ")")) && !std::regex_match(path, std::regex(party.places)))
      return std::string("only ") + party.places + " may include " + party.name;
  return "";
}

// Every forbidden include of a source text, as "path:line: header: why".
Words faults(const std::string& path, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  Words list;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    const std::string why = fault(path, match[1] == "\"", match[2]);
    if (!why.empty()) list.push_back(path + ":" + std::to_string(number) + ": " + match[2].str() + ": " + why);
  }
  return list;
}

}  // namespace

TEST_CASE("layers: every file of runtime/ includes only what its folder may use", "[layers]") {
  Words found;
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_tree("runtime"))) {
    const std::string ending = entry.path().extension().string();
    if (!entry.is_regular_file() || (ending != ".cpp" && ending != ".h")) continue;
    ++files;
    const std::string path = std::filesystem::relative(entry.path(), source_tree()).generic_string();
    for (std::string& line : faults(path, read_source(entry.path()))) found.push_back(std::move(line));
  }

  std::sort(found.begin(), found.end());
  for (const std::string& line : found) UNSCOPED_INFO(line);
  CHECK(found.empty());
  CHECK(files > 100);
}

TEST_CASE("layers: a forbidden include is found and named with its line", "[layers]") {
  const Words list = faults("runtime/physics/body.cpp", "#include \"physics/body.h\"\n\n#include \"scene/node.h\"\n");

  REQUIRE(list.size() == 1);
  CHECK(list[0] == "runtime/physics/body.cpp:3: scene/node.h: physics may not use scene");
}

TEST_CASE("layers: every kind of forbidden include is found", "[layers]") {
  const auto count = [](const char* path, const char* line) { return faults(path, line).size(); };

  CHECK(count("runtime/cli/main.cpp", "#include \"script/script.h\"") == 1);
  CHECK(count("runtime/scene/node.cpp", "#include \"render/renderer.h\"") == 1);
  CHECK(count("runtime/engine/engine.cpp", "  #  include <lua.h>  // no") == 1);
  CHECK(count("runtime/physics/world.h", "#include <btBulletDynamicsCommon.h>") == 1);
  CHECK(count("runtime/platform/window.h", "#include <SDL.h>") == 1);
  CHECK(count("runtime/engine/settings.cpp", "#include <nlohmann/json.hpp>") == 1);
  CHECK(count("runtime/include/tumble/tumble.h", "#include \"base/math.h\"") == 1);
  CHECK(count("runtime/sound/mixer.cpp", "#include \"base/math.h\"") == 1);
}

TEST_CASE("layers: what is allowed is not reported", "[layers]") {
  const auto count = [](const char* path, const char* line) { return faults(path, line).size(); };

  CHECK(count("runtime/cli/main.cpp", "#include \"tumble/tumble.h\"\n#include <CLI/CLI.hpp>\n#include \"cli/commands/commands.h\"") == 0);
  CHECK(count("runtime/engine/sync.cpp", "#include \"physics/world.h\"\n#include \"scene/scene.h\"") == 0);
  CHECK(count("runtime/platform/sdl/window.cpp", "#include <SDL.h>") == 0);
  CHECK(count("runtime/script/lua.h", "#include <lua.h>\n// #include \"cli/main.h\"") == 0);
}
