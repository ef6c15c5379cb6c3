// Small things that rows and the Script class share; no Lua here.
#pragma once

#include <string>

namespace tumble {

// A parameter of a row, as documents and messages show it.
struct Param {
  std::string name, type;
  bool optional = false;
};

// What a bound function gives that has pushed its results itself.
struct Results {
  int count = 0;
};

}  // namespace tumble
