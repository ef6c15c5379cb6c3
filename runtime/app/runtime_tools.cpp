// What a host asks of nodes, runs of tests, and needs on the command line.
#include <algorithm>
#include <filesystem>

#include "app/runtime_impl.h"
#include "assets/pack.h"
#include "platform/files.h"
#include "script/check.h"
#include "script/document.h"

namespace tumble {

Value to_inner(const Data& data) {
  return std::visit([](const auto& v) -> Value {
    if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) return {};
    else return v;
  }, data.content());
}

Data to_outer(const Value& value) {
  if (const bool* b = value.get<bool>()) return *b;
  if (value.is_number()) return value.number();
  if (const std::string* s = value.get<std::string>()) return *s;
  if (const Vec3* v = value.get<Vec3>()) return *v;
  return {};
}

// ---- tests

std::vector<std::pair<std::string, std::string>> Runtime::tests() {
  std::vector<std::pair<std::string, std::string>> list;
  Game& game = impl_->need_game("tests");
  for (const std::string& file : game.package().list("tests"))
    if (file.ends_with(".lua"))
      for (const std::string& claim : game.script().list_tests(file)) list.emplace_back(file, claim);
  return list;
}

std::string Runtime::run_test(const std::string& file, const std::string& claim) {
  Game& game = impl_->need_game("run_test");
  const std::vector<std::string> claims = game.script().list_tests(file);
  const auto found = std::find(claims.begin(), claims.end(), claim);
  if (found == claims.end()) return "no test '" + claim + "' in " + file;
  const int errors_before = game.errors();
  game.script().start_test(static_cast<int>(found - claims.begin()) + 1);
  constexpr int kLongest = 60 * 60 * 10;   // ticks: ten minutes of game time
  for (int i = 0; i < kLongest && !game.script().test_outcome; ++i) impl_->tick_once();
  if (!game.script().test_outcome) return game.errors() > errors_before && game.script().shown_error ? game.script().shown_error->text : "it did not end within ten minutes of game time";
  const auto [ok, text] = *game.script().test_outcome;
  if (!ok) return text;
  if (game.errors() > errors_before) return "a script failed meanwhile: " + (game.script().shown_error ? game.script().shown_error->text : std::string());
  return "";
}

// ---- nodes

// Node is a friend of Runtime; this is how its functions reach the game.
#define TUMBLE_NODE_GAME(call)                                                                 \
  Game& game = runtime_->impl_->need_game(call);                                               \
  const NodeId id{index_, generation_};                                                        \
  if (!game.engine().scene.get(id)) fail("node: ", call, ": this node was destroyed")

bool Node::is_alive() const {
  return runtime_ && runtime_->impl_->game && runtime_->impl_->game->engine().alive({index_, generation_});
}
std::string Node::name() const {
  TUMBLE_NODE_GAME("name");
  return game.engine().scene[id].name;
}
Vec3 Node::position() const {
  TUMBLE_NODE_GAME("position");
  return game.engine().scene.world(id).position;
}
Quat Node::rotation() const {
  TUMBLE_NODE_GAME("rotation");
  return game.engine().scene.world(id).rotation;
}
Vec3 Node::velocity() const {
  TUMBLE_NODE_GAME("velocity");
  const BodyComponent* body = game.engine().body(id);
  return body && game.engine().world() ? game.engine().world()->velocity(body->id) : Vec3{};
}
Data Node::get(const std::string& path) const {
  TUMBLE_NODE_GAME("get");
  const std::optional<Value> value = game.script().get_path(game.engine().scene.path(id), path);
  return value ? to_outer(*value) : Data{};
}
void Node::set(const std::string& path, const Data& value) {
  TUMBLE_NODE_GAME("set");
  game.script().set_path(game.engine().scene.path(id), path, to_inner(value));
}
#undef TUMBLE_NODE_GAME

// ---- tools

std::vector<Finding> check(const std::string& path) {
  const std::unique_ptr<Package> package = Package::open(path);
  CheckedGame game;
  game.read = [&](const std::string& file) { return package->read(file); };
  game.files = package->list();
  game.entry = package->entry();
  std::vector<Finding> findings;
  for (const CheckFinding& found : check_game(game)) findings.push_back({found.file, found.line, found.text, found.is_error});
  return findings;
}
std::string luacheck_config() { return check_config(); }

std::vector<std::pair<std::string, std::string>> generated_files() { return document_files(); }

void pack(const std::string& folder, const std::string& output, const std::string& program) {
  write_package(folder, output, program.empty() ? std::nullopt : std::optional<std::filesystem::path>(program));
}

bool has_packed_game(const std::string& program) {
  try {
    return Package::appended_to(program) != nullptr;
  } catch (const Error&) {
    return false;
  }
}

std::string storage_folder() {
  const std::filesystem::path folder = data_folder();
  return folder.empty() ? "" : (folder / "tumble").string();
}

bool display_available() { return Window::display_available(); }
std::string version() { return "0.1.0"; }

}  // namespace tumble
