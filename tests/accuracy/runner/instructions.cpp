#include "accuracy/runner/instructions.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace tumble::accuracy {

namespace {

constexpr double kCounted = 1;  // simulated seconds

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

// "summary: 123" is callgrind's total of a file, "totals:" that of a part.
std::optional<double> total(const std::string& file) {
  std::ifstream in(file);
  double sum = 0;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("summary: ")) sum += std::strtod(line.c_str() + 9, nullptr);
  if (sum <= 0) return {};
  return sum;
}

std::string read_all(const std::string& command) {
  std::string out;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return out;
  char buffer[256];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) out.append(buffer, n);
  const int status = pclose(pipe);
  return status == 0 ? out : "";
}

}  // namespace

std::optional<double> count_instructions(const std::string& engine, const std::string& id, int part, const Knobs& knobs) {
  char name[] = "/tmp/tumble-callgrind-XXXXXX";
  const int handle = mkstemp(name);
  if (handle < 0) return {};
  close(handle);
  const std::string seconds = read_all("timeout 300 valgrind --tool=callgrind --collect-atstart=no --callgrind-out-file=" + std::string(name) + " '" + own_program() +
                                       "' --count " + engine + " " + id + " " + std::to_string(part) + " " + setting_name(knobs) + " 2>/dev/null");
  const double simulated = std::strtod(seconds.c_str(), nullptr);
  std::optional<double> count = simulated > 0 ? total(name) : std::nullopt;
  std::filesystem::remove(name);
  if (count) *count /= simulated;
  return count;
}

int play_for_count(const std::string& engine, const std::string& id, int part, const Knobs& knobs) {
  const auto kind = std::find_if(engines().begin(), engines().end(), [&](const EngineKind& e) { return e.name == engine; });
  const auto found = std::find_if(all_cases().begin(), all_cases().end(), [&](const Case& c) { return c.id == id; });
  if (kind == engines().end() || found == all_cases().end()) fail("measure: --count: no engine '", engine, "' or no case '", id, "'");
  Trial trial(*kind, knobs, Effort::test);
  trial.count_for(kCounted);
  try {
    found->parts.at(static_cast<std::size_t>(part)).run(trial);
  } catch (const Recorder::Enough&) {
  } catch (const Missing&) {
    return 2;
  }
  double simulated = 0;
  for (const auto& scene : trial.scenes()) simulated += scene->simulated();
  std::printf("%.9g\n", simulated);
  return simulated > 0 ? 0 : 2;
}

}  // namespace tumble::accuracy
