// The Lua files of scripts/, built into the library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

// The text of "std/character.lua" or "boot/tasks.lua"; empty where there is none.
std::string_view embedded_script(const std::string& path);
std::vector<std::string> embedded_scripts();

}  // namespace tumble
