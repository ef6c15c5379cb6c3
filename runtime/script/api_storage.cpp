// What a game keeps from one run to the next.
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

void save(Script& s, std::string key, Value value) { s.storage.save(key, value, "storage.save"); }

// A file's top level runs again at every save, so there a key has what was stored when the game began: else what play
// has stored since would look like a change of the text.
Value load(Script& s, std::string key, std::optional<Value> missing) {
  const Value* stored = s.phase() == Phase::declare ? s.storage.load_first(key) : s.storage.load(key);
  return stored ? *stored : missing.value_or(Value{});
}

}  // namespace

void rows_storage(Area& a) {
  a.doc += " Each game has a file of its own, found by its folder's name, title and author, in the place that the system has for "
           "such: ~/.local/share/tumble (or $XDG_DATA_HOME/tumble), %APPDATA%\\tumble, ~/Library/Application Support/tumble. "
           "Bots and tests begin with nothing stored and leave nothing behind; a replay has what its recording began with.";
  a.fn<save>("save", "Stores a copy of the value under the key: numbers, strings, booleans, vec3, quat, color and tables of them, 1 MB in all; "
                     "nil removes the key. It is written to disk whole or not at all, after the tick.", "key", "value").acts();
  a.fn<load>("load", "A copy of what is stored under the key, or `default`. At the top level of a file: as it was when the game began.", "key", "default");
}

}  // namespace tumble
