// The source files that belong to this test program, for tests that read them.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace tumble {

// The folder of README.md; with a path, that file or folder in it.
std::filesystem::path source_tree(const std::string& path = "");

inline std::string read_source(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace tumble
