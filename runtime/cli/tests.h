// The kinds of tests that `tumble test` runs and counts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::cli {

// Test cases, added up over everything that ran.
struct Tally {
  int passed = 0, failed = 0;
};

// tumble_tests beside our program, all of it or what a Catch2 filter names. Throws Error where it is not built.
void run_cpp_tests(const std::string& filter, Tally& tally);
// The claims in a game's tests/*.lua, each in a game of its own.
void run_game_tests(const std::filesystem::path& game, Tally& tally);
// The scripts of a folder that must fail: the first line of each, "-- expect: TEXT", tells what the error must contain.
// `drawn`: with a picture after each tick, for what frame() may not do.
void run_error_scripts(const std::filesystem::path& folder, bool drawn, Tally& tally);
// A script FOLDER/run.sh that gets our build's folder and prints a line `ok ...` or `FAILED ...` for each test case.
void run_shell_tests(const std::filesystem::path& folder, Tally& tally);

}  // namespace tumble::cli
