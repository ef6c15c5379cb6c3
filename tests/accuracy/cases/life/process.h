// Work in a process of its own.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace tumble::accuracy {

// What the work returned there, byte by byte; nothing where the process died or used over 20 s of CPU time. An exception
// ends it with an empty answer.
std::optional<std::string> in_new_process(const std::function<std::string()>& work);

}  // namespace tumble::accuracy
