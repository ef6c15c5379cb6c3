// bench, first form: the cost of a tick in a few small worlds, without drawing.
#include <stdlib.h>

#include <cstdio>
#include <filesystem>

#include "cli/commands/commands.h"
#include "cli/program.h"
#include "cli/timing.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

struct World {
  const char* name;
  int settle;  // ticks before the clock starts
  const char* text;
};

const World kWorlds[] = {
    {"nothing at all", 60, "function update() end\n"},
    {"1000 nodes, moved by a script", 60, R"(
local nodes = {}
function start()
  for i = 1, 1000 do nodes[i] = scene.add { position = vec3(i, 0, 0), mesh = "box" } end
end
function update(dt)
  for i = 1, #nodes do nodes[i]:translate(0, dt, 0) end
end
)"},
    {"1000 rays against 100 bodies", 60, R"(
function start()
  for i = 1, 100 do scene.add { position = vec3(i % 10, 0, i // 10), mesh = "sphere", body = "static" } end
end
function update()
  for i = 1, 1000 do physics.raycast(i % 10, 5, i % 7, 0, -1, 0, 10) end
end
)"},
    {"200 boxes fall onto a pile, never asleep", 1, R"(
physics.sleeping = false
scene.add { position = vec3(0, -0.5, 0), mesh = { shape = "box", size = vec3(50, 1, 50) }, body = "static" }
function start()
  for i = 0, 199 do scene.add { position = vec3(i % 5 * 1.1, 0.6 + i // 25 * 1.1, i // 5 % 5 * 1.1), mesh = "box", body = {} } end
end
)"},
};

// A folder of its own for a world's main.lua, gone at the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "tumble.XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error("bench: no folder can be made in '" + fs::temp_directory_path().string() + "'");
    path = name;
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
};

int bench() {
  int status = 0;
  std::printf("processor time of a tick in ms, without drawing, over 300 ticks:\n\n  %-42s %8s %10s %8s\n", "", "median", "99 of 100", "worst");
  for (const World& world : kWorlds) {
    const Folder folder;
    write_file(folder.path / "main.lua", world.text, "bench");
    Runtime runtime;
    show_messages(runtime);
    runtime.load(folder.path.string());
    runtime.tick(world.settle);
    const Timing timing = time_ticks(runtime, 300);
    std::printf("  %-42s %8.3f %10.3f %8.3f\n", world.name, timing.median, timing.most_of_99, timing.worst);
    if (runtime.script_errors() > 0 || timing.ticks < 300) status = 1;
  }
  return status;
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
  CLI::App* verb = app.add_subcommand("bench", "Tell what a tick costs in a few small worlds; peers are not compared yet");
  verb->callback([&status] { status = bench(); });
}

}  // namespace tumble::cli
