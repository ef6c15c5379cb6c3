// What a game keeps from one run to the next: values by key, and the keys that a player chose for its actions. No file
// here: the program around the game reads and writes it (app/storage_file.h), and recordings carry it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/value.h"

namespace tumble {

struct Stored {
  std::map<std::string, Value> values;
  std::map<std::string, std::vector<std::string>> bindings;  // action -> raw names
  bool operator==(const Stored&) const = default;
};

// As JSON can hold it: vec3, quat and color are tables with one key, "$vec3" and so on; an author's own key that begins
// with "$" gets a second one.
Value pack_stored(const Stored& stored);
// Throws Error beginning with `where`.
Stored unpack_stored(const Value& value, const std::string& where);
std::string write_stored(const Stored& stored);
Stored read_stored(const std::string& text, const std::string& file);

class Storage {
 public:
  static constexpr std::size_t kMostBytes = 1 << 20;  // of all values and keys as JSON

  // A run begins with what was stored before.
  void begin(Stored stored);
  // A nil value removes the key. Throws Error, beginning with `call`, for what cannot be stored or is too much.
  void save(const std::string& key, const Value& value, const std::string& call);
  void save_binding(const std::string& action, const std::vector<std::string>& names);
  void forget_binding(const std::string& action);
  // nullptr where nothing is stored under that key.
  const Value* load(const std::string& key) const { return find(now_, key); }
  const Value* load_first(const std::string& key) const { return find(first_, key); }  // as it was when the run began
  const Stored& first() const { return first_; }
  const Stored& now() const { return now_; }
  // Was anything changed since this was asked last?
  bool take_changed();

 private:
  static const Value* find(const Stored& stored, const std::string& key);

  Stored first_, now_;
  std::map<std::string, std::size_t> sizes_;  // of values_, as JSON, bytes
  std::size_t bytes_ = 0;                     // their sum
  bool changed_ = false;
};

}  // namespace tumble
