// The running program and the machine around it: where it lies, where its source is, other programs, the terminal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tumble/tumble.h"

namespace tumble::cli {

std::filesystem::path own_program();
// The clone that this program was built from: TUMBLE_SOURCE, else two folders above the program (build/release/tumble).
// Throws Error, beginning with `call`, where that is no clone.
std::filesystem::path source_tree(const std::string& call);

// Runs a program to its end with these arguments. Its status, or 128 and the signal's number. `each_line` gets what it
// writes to its standard output; without it that goes where ours goes.
int run_program(const std::vector<std::string>& words, const std::function<void(const std::string&)>& each_line = {});

// The text as one word of a shell's command line.
std::string shell_word(const std::string& text);

// What a game says goes to the terminal: print() to standard output, the rest to standard error, each script error once.
void show_messages(Runtime& runtime);

// "1 test", "3 tests".
std::string count_text(std::int64_t count, const std::string& noun);
// The name of a game for files made of it: "games/basketball/" -> "basketball", "a.tumble" -> "a".
std::string game_name(const std::string& game);
// Writes a whole file or throws Error, beginning with `call`.
void write_file(const std::filesystem::path& file, const std::string& text, const std::string& call);
// "" where there is no such file.
std::string read_file(const std::filesystem::path& file);

}  // namespace tumble::cli
