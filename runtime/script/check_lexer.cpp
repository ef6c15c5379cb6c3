#include "script/check_lexer.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace tumble {

namespace {

constexpr std::array kKeywords = {"and", "break", "do",  "else", "elseif", "end",    "false", "for",  "function", "goto",  "if",
                                  "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_exponent(char c) { return c == 'e' || c == 'E' || c == 'p' || c == 'P'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    if (text_.starts_with("#")) skip_line();
    while (at_ < text_.size()) step();
    add(Token::Kind::end, "");
    add(Token::Kind::end, "");
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  void add(Token::Kind kind, std::string text) { tokens_.push_back({kind, std::move(text), line_}); }
  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  void step() {
    const char c = peek();
    if (c == '\n') ++line_;
    if (std::isspace(static_cast<unsigned char>(c))) ++at_;
    else if (c == '-' && peek(1) == '-') comment();
    else if (begins_name(c)) name();
    else if (std::isdigit(static_cast<unsigned char>(c)) || (c == '.' && std::isdigit(static_cast<unsigned char>(peek(1))))) number();
    else if (c == '"' || c == '\'') quoted(c);
    else if (c == '[' && long_level() >= 0) long_text(true);
    else symbol();
  }

  void comment() {
    at_ += 2;
    if (peek() == '[' && long_level() >= 0) long_text(false);
    else skip_line();
  }
  void name() {
    const std::size_t begin = at_;
    while (in_name(peek())) ++at_;
    std::string word(text_.substr(begin, at_ - begin));
    const bool keyword = std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
    add(keyword ? Token::Kind::symbol : Token::Kind::name, std::move(word));
  }
  void number() {
    const std::size_t begin = at_;
    while (in_name(peek()) || (peek() == '.' && peek(1) != '.') || ((peek() == '-' || peek() == '+') && is_exponent(text_[at_ - 1]))) ++at_;
    add(Token::Kind::number, std::string(text_.substr(begin, at_ - begin)));
  }
  void quoted(char quote) {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && peek() != quote && peek() != '\n') at_ += peek() == '\\' ? 2 : 1;
    at_ = std::min(at_, text_.size());
    add(Token::Kind::text, std::string(text_.substr(begin, at_ - begin)));
    if (peek() == quote) ++at_;
  }
  // How many equals signs stand in the bracket that opens here; -1 where none does.
  int long_level() const {
    std::size_t i = 1;
    while (peek(i) == '=') ++i;
    return peek(i) == '[' ? static_cast<int>(i) - 1 : -1;
  }
  void long_text(bool keep) {
    const std::string close = "]" + std::string(static_cast<std::size_t>(long_level()), '=') + "]";
    const std::size_t begin = at_ + close.size(), end = std::min(text_.find(close, begin), text_.size());
    if (keep) add(Token::Kind::text, std::string(text_.substr(begin, end - begin)));
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = std::min(end + close.size(), text_.size());
  }
  void symbol() {
    static constexpr std::array kLong = {"...", "..", "==", "~=", "<=", ">=", "//", "::", "<<", ">>"};
    for (const std::string_view longer : kLong)
      if (text_.substr(at_).starts_with(longer)) {
        add(Token::Kind::symbol, std::string(longer));
        at_ += longer.size();
        return;
      }
    add(Token::Kind::symbol, std::string(1, peek()));
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> lua_tokens(std::string_view text) { return Lexer(text).run(); }

}  // namespace tumble
