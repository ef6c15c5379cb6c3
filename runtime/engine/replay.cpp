#include "engine/replay.h"

#include "base/error.h"
#include "base/text.h"
#include "engine/json.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace tumble {

namespace {

constexpr int kVersion = 1;

const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names = {"press", "release", "value", "pointer_move", "wheel", "text"};
  return names;
}

// 64 bits do not fit JSON's numbers as most programs read them.
std::string hex(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

// [tick, kind, name, numbers ...]: a name where the kind has one, the numbers that the kind has.
Value write_event(std::uint64_t tick, const InputEvent& event) {
  List list{static_cast<std::int64_t>(tick), kind_names()[static_cast<std::size_t>(event.kind)]};
  switch (event.kind) {
    case InputKind::press:
    case InputKind::release:
    case InputKind::text: list.push_back(event.name); break;
    case InputKind::value: list.insert(list.end(), {event.name, event.value}); break;
    case InputKind::wheel: list.push_back(event.value); break;
    case InputKind::pointer_move: list.insert(list.end(), {event.x, event.y, event.dx, event.dy}); break;
  }
  return list;
}

// Reads one part after the other of a list, each with its own sentence where it is wrong.
class Parts {
 public:
  Parts(const Value& value, std::string where) : list_(value.get<List>()), where_(std::move(where)) {
    if (!list_) fail(where_, ": list expected, got ", kind_name(value));
  }
  std::uint64_t tick() {
    const std::int64_t* whole = next("tick").get<std::int64_t>();
    if (!whole || *whole < 0) fail(where_, ": tick: whole number from 0 expected, got ", text((*list_)[next_ - 1]));
    return static_cast<std::uint64_t>(*whole);
  }
  const std::string& word(const char* what) {
    const std::string* word = next(what).get<std::string>();
    if (!word) fail(where_, ": ", what, ": string expected, got ", kind_name((*list_)[next_ - 1]));
    return *word;
  }
  double number(const char* what) {
    const Value& value = next(what);
    if (!value.is_number()) fail(where_, ": ", what, ": number expected, got ", kind_name(value));
    return value.number();
  }
  void end() const {
    if (next_ < list_->size()) fail(where_, " has ", list_->size(), " parts; ", next_, " expected");
  }
  const std::string& where() const { return where_; }

 private:
  const Value& next(const char* what) {
    if (next_ >= list_->size()) fail(where_, ": ", what, " is missing");
    return (*list_)[next_++];
  }
  const List* list_;
  std::string where_;
  std::size_t next_ = 0;
};

InputKind read_kind(const std::string& word, const std::string& where) {
  for (std::size_t i = 0; i < kind_names().size(); ++i)
    if (kind_names()[i] == word) return static_cast<InputKind>(i);
  fail(where, ": unknown '", word, "'; expected one of ", join(kind_names()), did_you_mean(word, kind_names()));
}

std::pair<std::uint64_t, InputEvent> read_event(Parts parts) {
  InputEvent event;
  const std::uint64_t tick = parts.tick();
  event.kind = read_kind(parts.word("kind"), parts.where());
  const bool has_key = event.kind == InputKind::press || event.kind == InputKind::release || event.kind == InputKind::value;
  if (has_key || event.kind == InputKind::text) event.name = parts.word("name");
  const bool is_shape = event.kind == InputKind::value && event.name == kScreenShape;
  if (has_key && !is_shape && !is_raw_input_name(event.name))
    fail(parts.where(), ": no key or button '", event.name, "'", did_you_mean(event.name, raw_input_names()));
  if (event.kind == InputKind::value || event.kind == InputKind::wheel) event.value = parts.number("value");
  if (event.kind == InputKind::pointer_move) {
    event.x = parts.number("x");
    event.y = parts.number("y");
    event.dx = parts.number("dx");
    event.dy = parts.number("dy");
  }
  parts.end();
  return {tick, event};
}

const Value& require(const Value& root, const char* key, const std::string& file) {
  const Value* value = root.find(key);
  if (!value) fail(file, ": no '", key, "'; it is no recording or was cut off");
  return *value;
}

std::uint64_t read_hex(const Value& root, const char* key, const std::string& file) {
  const std::string* text = require(root, key, file).get<std::string>();
  std::uint64_t number = 0;
  if (text) {
    const auto result = std::from_chars(text->data(), text->data() + text->size(), number, 16);
    if (!text->empty() && result.ec == std::errc() && result.ptr == text->data() + text->size()) return number;
  }
  fail(file, ": ", key, ": string of up to 16 hexadecimal digits expected, got ", tumble::text(require(root, key, file)));
}

void read_head(const Value& root, const std::string& file, Recording& recording) {
  const std::int64_t* version = require(root, "tumble_recording", file).get<std::int64_t>();
  if (!version || *version != kVersion)
    fail(file, ": recording of version ", text(*root.find("tumble_recording")), "; this runtime reads version ", kVersion);
  const std::string* game = require(root, "game", file).get<std::string>();
  if (!game) fail(file, ": game: string expected, got ", kind_name(*root.find("game")));
  recording.game = *game;
  recording.seed = read_hex(root, "seed", file);
  recording.hash = read_hex(root, "hash", file);
  const Value& rate = require(root, "tick_rate", file);
  if (!rate.is_number() || rate.number() <= 0) fail(file, ": tick_rate: number above 0 expected, got ", text(rate));
  recording.tick_rate = rate.number();
  if (const Value* stored = root.find("stored")) recording.stored = unpack_stored(*stored, file + ": stored");
  recording.ticks = Parts(List{require(root, "ticks", file)}, file + ": ticks").tick();
}

}  // namespace

std::string write_recording(const Recording& recording) {
  List events;
  for (const auto& [tick, event] : recording.events) events.push_back(write_event(tick, event));
  return write_json(Map{{"tumble_recording", kVersion},
                        {"game", recording.game},
                        {"seed", hex(recording.seed)},
                        {"tick_rate", recording.tick_rate},
                        {"ticks", static_cast<std::int64_t>(recording.ticks)},
                        {"hash", hex(recording.hash)},
                        {"stored", pack_stored(recording.stored)},
                        {"events", std::move(events)}});
}

Recording read_recording(const std::string& text, const std::string& file) {
  const Value root = parse_json(text, file);
  Recording recording;
  read_head(root, file, recording);
  const List* events = require(root, "events", file).get<List>();
  if (!events) fail(file, ": events: list expected, got ", kind_name(*root.find("events")));
  for (std::size_t i = 0; i < events->size(); ++i) {
    const std::string where = file + ": events[" + std::to_string(i + 1) + "]";
    recording.events.push_back(read_event(Parts((*events)[i], where)));
    const std::uint64_t tick = recording.events.back().first;
    const std::uint64_t before = i > 0 ? recording.events[i - 1].first : 0;
    if (tick < before) fail(where, ": tick ", tick, " comes after tick ", before);
    if (tick >= recording.ticks) fail(where, ": tick ", tick, " is outside the recording of ", recording.ticks, " ticks");
  }
  return recording;
}

}  // namespace tumble
