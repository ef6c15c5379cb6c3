// Lua text as words, for checks that need no program flow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

struct Token {
  enum class Kind { name, text, number, symbol, end } kind = Kind::end;
  std::string text;   // of a string: what is between its quotes, escapes as written
  int line = 0;
  bool is(std::string_view symbol_or_name) const { return kind != Kind::text && text == symbol_or_name; }
  bool is_name() const { return kind == Kind::name; }
  bool is_text() const { return kind == Kind::text; }
};

// Comments left out; ends with a token of kind end, twice, so that the one after the last may be looked at. What is no
// Lua becomes symbols: who compiles the text has said so already. Keywords are symbols.
std::vector<Token> lua_tokens(std::string_view text);

}  // namespace tumble
