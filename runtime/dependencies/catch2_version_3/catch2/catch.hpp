// Lets tests written for Catch2's version 2 (Debian 12) compile with version 3 (Debian 13).
#pragma once

#include <catch2/catch_all.hpp>

#include <string>
#include <utility>

using Catch::Approx;

namespace Catch {

using Matchers::EndsWith;
using Matchers::Equals;
using Matchers::StartsWith;
inline auto Contains(std::string text) { return Matchers::ContainsSubstring(std::move(text)); }

}  // namespace Catch
