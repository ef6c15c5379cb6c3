// The verbs of the program, a file each. Every add_ function describes its verb to the command line, and the verb leaves
// the exit status in `status`: 0 only where all went well. What it cannot do it throws as tumble::Error.
#pragma once

#include <CLI/CLI.hpp>

namespace tumble::cli {

void add_play(CLI::App& app, int& status);
void add_new(CLI::App& app, int& status);
void add_test(CLI::App& app, int& status);
void add_check(CLI::App& app, int& status);
void add_measure(CLI::App& app, int& status);
void add_bench(CLI::App& app, int& status);
void add_pack(CLI::App& app, int& status);
void add_docs(CLI::App& app, int& status);

// A program with a game behind it takes play's options without the verb.
void add_packed_play(CLI::App& app, const std::string& program, int& status);

}  // namespace tumble::cli
