// docs: writes what is generated into the source tree, or compares it.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

// Files in the generated folders that are not generated any more.
std::vector<fs::path> left_over(const fs::path& tree, const std::vector<std::pair<std::string, std::string>>& files) {
  std::set<fs::path> known, folders;
  for (const auto& [path, text] : files) {
    known.insert(tree / path);
    folders.insert((tree / path).parent_path());
  }
  std::vector<fs::path> found;
  for (const fs::path& folder : folders)
    if (fs::is_directory(folder))
      for (const auto& entry : fs::directory_iterator(folder))
        if (!known.count(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

int check_docs(const fs::path& tree) {
  const auto files = generated_files();
  int stale = 0;
  for (const auto& [path, text] : files)
    if (!fs::exists(tree / path) || read_file(tree / path) != text) {
      std::cerr << "stale: " << path << '\n';
      ++stale;
    }
  for (const fs::path& path : left_over(tree, files)) {
    std::cerr << "left over: " << fs::relative(path, tree).string() << '\n';
    ++stale;
  }
  if (stale) std::cerr << "docs: " << count_text(stale, "file") << " to bring up to date; run ./tumble docs and commit what it writes\n";
  else std::cout << "docs: all " << files.size() << " files are as the table gives them\n";
  return stale ? 1 : 0;
}

int write_docs(const fs::path& tree) {
  const auto files = generated_files();
  int written = 0;
  for (const auto& [path, text] : files) {
    const fs::path file = tree / path;
    if (fs::exists(file) && read_file(file) == text) continue;
    fs::create_directories(file.parent_path());
    write_file(file, text, "docs");
    std::cout << "wrote " << path << '\n';
    ++written;
  }
  for (const fs::path& path : left_over(tree, files)) std::cout << "left over, remove it: " << fs::relative(path, tree).string() << '\n';
  std::cout << "docs: " << written << " of " << files.size() << " files have changed\n";
  return 0;
}

}  // namespace

void add_docs(CLI::App& app, int& status) {
  auto check = std::make_shared<bool>(false);
  CLI::App* verb = app.add_subcommand("docs", "Write docs/api and scripts/types from the table behind the bindings");
  verb->add_flag("--check", *check, "Write nothing; fail and name the files that differ");
  verb->callback([check, &status] { status = *check ? check_docs(source_tree("docs")) : write_docs(source_tree("docs")); });
}

}  // namespace tumble::cli
