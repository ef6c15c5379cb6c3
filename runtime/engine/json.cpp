#include "engine/json.h"

#include "base/error.h"
#include "base/text.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace tumble {

namespace {

constexpr std::size_t kMaxDepth = 100;               // tables in tables; readers of Values recurse
constexpr std::size_t kMaxBytes = 64 * 1024 * 1024;  // of text; a Value needs some times as much
constexpr std::size_t kLineWidth = 100;
constexpr std::uint64_t kLargestWhole = std::numeric_limits<std::int64_t>::max();

struct Line {
  std::size_t line = 1, column = 1;
};

Line line_at(const std::string& text, std::size_t bytes) {
  Line at;
  for (std::size_t i = 0; i < bytes && i < text.size(); ++i) {
    ++at.column;
    if (text[i] == '\n') at = {at.line + 1, 1};
  }
  return at;
}

// Builds a Value from the parser's calls. Open tables and lists are on a stack; a finished one goes into the one below.
class Builder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  Builder(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  bool null() { return add({}); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(number_integer_t value) { return add(std::int64_t{value}); }
  bool number_unsigned(number_unsigned_t value) {
    return value <= kLargestWhole ? add(static_cast<std::int64_t>(value)) : add(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) { return add(value); }
  bool string(string_t& value) { return add(std::move(value)); }
  bool binary(binary_t&) { return false; }

  bool start_object(std::size_t) { return open(Map{}); }
  bool start_array(std::size_t) { return open(List{}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(string_t& name) {
    Level& level = levels_.back();
    if (!level.keys.insert(name).second)
      fail(file_, ": ", path(), path().empty() ? "" : ": ", "the key '", name, "' stands here twice");
    level.key = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception& error) {
    // The parser counts the bytes it took, the wrong one included.
    const Line at = line_at(text_, position > 0 ? position - 1 : 0);
    fail(file_, ":", at.line, ":", at.column, ": ", reason(error.what(), last_token));
  }

  Value take() { return std::move(result_); }

 private:
  struct Level {
    Value value;
    std::string key;
    std::set<std::string> keys;
  };

  // The library says "[json.exception...] parse error at line 1, column 2: syntax error while parsing X - WHY; ...".
  static std::string reason(const std::string& what, const std::string& last_token) {
    if (what.find("number overflow") != std::string::npos) return "the number " + last_token + " is too large";
    const std::size_t dash = what.find(" - ");
    std::string why = dash == std::string::npos ? what : what.substr(dash + 3);
    if (const std::size_t token = why.find("; last read"); token != std::string::npos) {
      const std::size_t expected = why.find("; expected");
      why = why.substr(0, token) + (expected == std::string::npos ? "" : why.substr(expected));
    }
    return "not JSON: " + why;
  }

  std::string path() const {
    std::string text;
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      if (const List* list = levels_[i].value.get<List>()) text += "[" + std::to_string(list->size() + 1) + "]";
      else text += (text.empty() ? "" : ".") + levels_[i].key;
    }
    return text;
  }

  bool open(Value value) {
    if (levels_.size() >= kMaxDepth) fail(file_, ": tables stand in one another more than ", kMaxDepth, " deep");
    levels_.push_back({std::move(value), {}, {}});
    return true;
  }

  bool close() {
    Value done = std::move(levels_.back().value);
    levels_.pop_back();
    return add(std::move(done));
  }

  bool add(Value value) {
    if (levels_.empty()) {
      result_ = std::move(value);
      return true;
    }
    Level& level = levels_.back();
    if (List* list = level.value.get<List>()) list->push_back(std::move(value));
    else level.value.get<Map>()->emplace_back(level.key, std::move(value));
    return true;
  }

  const std::string& text_;
  const std::string& file_;
  std::vector<Level> levels_;
  Value result_;
};

// ---- writing

std::string quoted(const std::string& text) {
  // The library knows the escapes; what is not UTF-8 becomes a replacement character instead of an exception.
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string number(double value) {
  if (!std::isfinite(value)) fail("JSON cannot hold the number ", number_text(value), "; leave the key out");
  return number_text(value);
}

// A real number that happens to be whole keeps a ".0", since Lua tells 1.0 from 1.
std::string real_number(double value) {
  const std::string text = number(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string numbers(std::initializer_list<double> values) {
  std::vector<std::string> parts;
  for (const double value : values) parts.push_back(number(value));
  return "[" + join(parts) + "]";
}

struct Writer {
  std::size_t indent = 0;

  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(std::int64_t i) const { return std::to_string(i); }
  std::string operator()(double d) const { return real_number(d); }
  std::string operator()(const std::string& s) const { return quoted(s); }
  std::string operator()(Vec3 v) const { return numbers({v.x, v.y, v.z}); }
  std::string operator()(Quat q) const { return numbers({q.x, q.y, q.z, q.w}); }
  // A colour between the steps of 255 would change a little each time it is saved, so that one is written in numbers.
  std::string operator()(const Color& c) const {
    const std::string hex = to_hex(c);
    return parse_color(hex) == c ? quoted(hex) : numbers({c.r, c.g, c.b, c.a});
  }
  std::string operator()(const Reference&) const { fail("JSON cannot hold a node or joint; write its name or id"); }
  std::string operator()(const List& list) const {
    std::vector<std::string> parts;
    for (const Value& value : list) parts.push_back(inner(value));
    return enclosed('[', parts, ']', "");
  }
  std::string operator()(const Map& map) const {
    std::vector<std::string> parts;
    for (const auto& [key, value] : map) parts.push_back(quoted(key) + ": " + inner(value));
    return enclosed('{', parts, '}', " ");
  }

 private:
  std::string inner(const Value& value) const { return std::visit(Writer{indent + 2}, value.data); }

  // On one line where that fits and nothing inside needs more.
  std::string enclosed(char open, const std::vector<std::string>& parts, char close, const char* space) const {
    if (parts.empty()) return {open, close};
    const std::string line = join(parts);
    if (indent > 0 && indent + line.size() + 4 <= kLineWidth && line.find('\n') == std::string::npos)
      return open + (space + line + space) + close;
    const std::string margin(indent + 2, ' ');
    return open + ("\n" + margin) + join(parts, ",\n" + margin) + "\n" + std::string(indent, ' ') + close;
  }
};

}  // namespace

Value parse_json(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes) fail(file, ": a JSON file may have ", kMaxBytes, " bytes (got ", text.size(), ")");
  Builder builder(text, file);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

std::string write_json(const Value& value) { return std::visit(Writer{}, value.data) + "\n"; }

}  // namespace tumble
