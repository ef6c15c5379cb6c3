#include "script/embedded.h"

namespace tumble {

// Generated at build time from scripts/boot and scripts/std.
std::string_view embedded_boot_file(std::string_view file);
std::string_view embedded_std_file(std::string_view file);

std::string_view embedded_script(const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string folder = path.substr(0, slash), file = slash == std::string::npos ? "" : path.substr(slash + 1);
  if (folder == "boot") return embedded_boot_file(file);
  if (folder == "std") return embedded_std_file(file);
  return {};
}

std::vector<std::string> embedded_scripts() {
  std::vector<std::string> list;
  std::string_view names = TUMBLE_STD_FILES;  // "character.lua|tween.lua", by CMake
  while (!names.empty()) {
    const std::size_t bar = std::min(names.find('|'), names.size());
    list.push_back("std/" + std::string(names.substr(0, bar)));
    names.remove_prefix(std::min(bar + 1, names.size()));
  }
  return list;
}

}  // namespace tumble
