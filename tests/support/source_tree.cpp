#include "support/source_tree.h"

namespace tumble {

std::filesystem::path source_tree(const std::string& path) {
  const std::filesystem::path top = TUMBLE_SOURCE_TREE;
  return path.empty() ? top : top / path;
}

}  // namespace tumble
