// The program behind `tumble bench`: prints the figures and, where asked, writes them as JSON.
#include <cstdio>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/text.h"
#include "bench/bench.h"

namespace tumble::bench {

namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

void write_json(const std::vector<Result>& results, const std::string& file) {
  std::ofstream out(file);
  out << "{\"results\": [";
  const char* between = "\n";
  for (const Result& r : results) {
    char value[32];
    std::snprintf(value, sizeof value, "%.6g", r.value);
    out << between << "  {\"name\": " << quoted(r.name) << ", \"value\": " << value << ", \"unit\": " << quoted(r.unit) << ", \"goal\": " << quoted(r.goal)
        << ",\n   \"how\": " << quoted(r.how) << "}";
    between = ",\n";
  }
  out << "\n]}\n";
  if (!out.flush()) fail("bench: --json: '", file, "' cannot be written");
}

int run(const std::vector<std::string>& parts, const std::string& json) {
  std::vector<std::string> names;
  for (const Bench& bench : all()) names.push_back(bench.name);
  for (const std::string& part : parts)
    if (std::find(names.begin(), names.end(), part) == names.end()) fail("bench: no part '", part, "'", did_you_mean(part, names), "; parts: ", join(names));
  std::vector<Result> results;
  for (const Bench& bench : all()) {
    if (!parts.empty() && std::find(parts.begin(), parts.end(), bench.name) == parts.end()) continue;
    for (const Result& r : bench.run()) {
      std::printf("%-28s %10.3f %-9s %s\n    %s\n", r.name.c_str(), r.value, r.unit.c_str(), r.goal.empty() ? "" : ("(goal: " + r.goal + ")").c_str(), r.how.c_str());
      std::fflush(stdout);
      results.push_back(r);
    }
  }
  if (!json.empty()) write_json(results, json);
  return 0;
}

}  // namespace

}  // namespace tumble::bench

int main(int count, char** words) {
  std::vector<std::string> parts;
  std::string json;
  for (int i = 1; i < count; ++i) {
    if (!std::strcmp(words[i], "--json") && i + 1 < count) json = words[++i];
    else parts.emplace_back(words[i]);
  }
  try {
    return tumble::bench::run(parts, json);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
