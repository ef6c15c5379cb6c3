#include "cli/tests.h"

#include <algorithm>
#include <iostream>
#include <regex>

#include "cli/program.h"
#include "tumble/tumble.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

void count(bool passed, Tally& tally) { ++(passed ? tally.passed : tally.failed); }

// How a suite did, in one line after its failures.
void conclude(const std::string& suite, const Tally& before, const Tally& after) {
  std::cout << suite << ": " << after.passed - before.passed << " passed";
  if (after.failed > before.failed) std::cout << ", " << after.failed - before.failed << " FAILED";
  std::cout << std::endl;
}

std::vector<fs::path> lua_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".lua") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// What a script that must fail says: its first failure within two seconds of game time, or how it could not be loaded.
std::string first_failure(const fs::path& script, bool drawn) {
  std::string text;
  Options options;
  options.offscreen = drawn;
  Runtime runtime(options);
  runtime.on_script_error([&](const ScriptError& error) {
    if (text.empty()) text = error.text;
  });
  try {
    runtime.load(script.string());
    for (int i = 0; i < 120 && text.empty() && runtime.is_loaded(); ++i) {
      runtime.tick();
      runtime.draw();
    }
  } catch (const Error& error) {
    if (text.empty()) text = error.what();
  }
  return text;
}

}  // namespace

void run_cpp_tests(const std::string& filter, Tally& tally) {
  const fs::path program = own_program().parent_path() / "tumble_tests";
  if (!fs::exists(program))
    throw Error("test: '" + program.string() + "' is missing; build it with: ninja -C " + shell_word(program.parent_path().string()) + " tumble_tests");
  std::vector<std::string> words = {program.string()};
  if (!filter.empty()) words.push_back(filter);
  // "All tests passed (16 assertions in 4 test cases)" or "test cases:  4 |  3 passed | 1 failed".
  const std::regex all_passed(R"(All tests passed \(.* in (\d+) test cases?\))"), passed(R"(^test cases:.*?(\d+) passed.*)"), failed(R"(^test cases:.*?(\d+) failed.*)");
  Tally now;
  const int status = run_program(words, [&](const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, all_passed)) now.passed = std::stoi(match[1]);
    if (std::regex_match(line, match, passed)) now.passed = std::stoi(match[1]);
    if (std::regex_match(line, match, failed)) now.failed = std::stoi(match[1]);
    std::cout << line << std::endl;
  });
  if (status != 0 && now.failed == 0) now.failed = 1;  // it broke off, or knew no such test
  const Tally before = tally;
  tally.passed += now.passed;
  tally.failed += now.failed;
  conclude("C++", before, tally);
}

void run_game_tests(const fs::path& game, Tally& tally) {
  const Tally before = tally;
  const std::string name = game.string();
  std::vector<std::pair<std::string, std::string>> claims;
  std::string failure;
  try {
    Runtime runtime;
    runtime.on_script_error([&](const ScriptError& error) { failure = error.text; });
    runtime.load(name);
    claims = runtime.tests();
  } catch (const Error& error) {
    failure = error.what();
  }
  if (!failure.empty() || claims.empty()) {
    std::cout << "FAILED " << name << ": " << (failure.empty() ? "there are no tests in its folder 'tests'" : failure) << '\n';
    count(false, tally);
  }
  for (const auto& [file, claim] : claims) {
    std::string wrong;
    try {
      Runtime runtime;
      runtime.load(name);
      wrong = runtime.run_test(file, claim);
    } catch (const Error& error) {
      wrong = error.what();
    }
    if (!wrong.empty()) std::cout << "FAILED " << name << "/" << file << ": " << claim << "\n  " << wrong << std::endl;
    count(wrong.empty(), tally);
  }
  conclude(name, before, tally);
}

void run_error_scripts(const fs::path& folder, bool drawn, Tally& tally) {
  const Tally before = tally;
  for (const fs::path& script : lua_files(folder)) {
    const std::string text = read_file(script), mark = "-- expect: ";
    const std::string expected = text.starts_with(mark) ? text.substr(mark.size(), text.find('\n') - mark.size()) : "";
    const std::string got = first_failure(script, drawn);
    const bool right = !expected.empty() && got.find(expected) != std::string::npos;
    if (!right)
      std::cout << "FAILED " << script.string() << "\n  expected an error with: " << (expected.empty() ? "(its first line must be `-- expect: TEXT`)" : expected)
                << "\n  got: " << (got.empty() ? "none" : got) << std::endl;
    count(right, tally);
  }
  conclude(folder.string(), before, tally);
}

void run_shell_tests(const fs::path& folder, Tally& tally) {
  const Tally before = tally;
  const int status = run_program({(folder / "run.sh").string(), own_program().parent_path().string()}, [&](const std::string& line) {
    if (line.starts_with("ok ")) return count(true, tally);
    if (line.starts_with("FAILED ")) count(false, tally);
    std::cout << line << std::endl;
  });
  const bool told = tally.failed > before.failed || tally.passed > before.passed;
  if (!told || (status != 0 && tally.failed == before.failed)) {
    std::cout << "FAILED " << folder.string() << ": run.sh broke off with status " << status << '\n';
    count(false, tally);
  }
  conclude(folder.string(), before, tally);
}

}  // namespace tumble::cli
