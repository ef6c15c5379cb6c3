#include "engine/storage.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "engine/json.h"

namespace tumble {

namespace {

constexpr int kVersion = 1;

Value tagged(const char* tag, Value content) { return Map{{tag, std::move(content)}}; }

// What JSON can hold and give back as it was; `where` is a path such as best.times[2].
Value packed(const Value& value, const std::string& where) {
  if (value.is<Reference>()) fail(where, ": ", kind_name(value), " cannot be stored; store its name or its position");
  if (value.is_number() && !std::isfinite(value.number())) fail(where, ": a finite number expected, got ", text(value));
  if (const std::string* string = value.get<std::string>(); string && !is_utf8(*string)) fail(where, ": the text is not UTF-8");
  if (value.is<Vec3>()) return tagged("$vec3", value);
  if (value.is<Quat>()) return tagged("$quat", value);
  if (value.is<Color>()) return tagged("$color", value);
  if (const List* list = value.get<List>()) {
    List result;
    for (const Value& entry : *list) result.push_back(packed(entry, where + "[" + std::to_string(result.size() + 1) + "]"));
    return result;
  }
  if (const Map* map = value.get<Map>()) {
    Map result;
    for (const auto& [key, entry] : *map) {
      if (!is_utf8(key)) fail(where, ": a key is not UTF-8");
      result.emplace_back(key.starts_with('$') ? "$" + key : key, packed(entry, where + "." + key));
    }
    return result;
  }
  return value;
}

std::vector<double> numbers_of(const Value& value, std::size_t count, const std::string& where) {
  std::vector<double> numbers;
  if (const List* list = value.get<List>())
    for (const Value& entry : *list)
      if (entry.is_number()) numbers.push_back(entry.number());
  if (numbers.size() != count) fail(where, ": a list of ", count, " numbers expected, got ", text(value));
  return numbers;
}

Value untagged(const std::string& tag, const Value& content, const std::string& where) {
  if (tag == "$vec3") {
    const auto n = numbers_of(content, 3, where);
    return Vec3{n[0], n[1], n[2]};
  }
  if (tag == "$quat") {
    const auto n = numbers_of(content, 4, where);
    return Quat{n[0], n[1], n[2], n[3]};
  }
  if (tag != "$color") fail(where, ": unknown kind '", tag, "'; it comes from a later version");
  if (const std::string* hex = content.get<std::string>())
    if (const auto color = parse_color(*hex)) return *color;
  const auto n = numbers_of(content, 4, where);
  return Color{n[0], n[1], n[2], n[3]};
}

Value unpacked(const Value& value, const std::string& where) {
  if (const List* list = value.get<List>()) {
    List result;
    for (const Value& entry : *list) result.push_back(unpacked(entry, where + "[" + std::to_string(result.size() + 1) + "]"));
    return result;
  }
  const Map* map = value.get<Map>();
  if (!map) return value;
  const auto is_tag = [](const std::string& key) { return key.starts_with('$') && !key.starts_with("$$"); };
  if (map->size() == 1 && is_tag(map->front().first)) return untagged(map->front().first, map->front().second, where);
  Map result;
  for (const auto& [key, entry] : *map) result.emplace_back(key.starts_with("$$") ? key.substr(1) : key, unpacked(entry, where + "." + key));
  return result;
}

const Map& table(const Value& root, const char* key, const std::string& where) {
  static const Map none;
  const Value* value = root.find(key);
  if (!value) return none;
  if (!value->is<Map>()) fail(where, ": ", key, ": a table expected, got ", kind_name(*value));
  return *value->get<Map>();
}

std::string megabytes(std::size_t bytes) {
  char words[32];
  std::snprintf(words, sizeof words, "%.3g MB", static_cast<double>(bytes) / (1 << 20));
  return words;
}

}  // namespace

Value pack_stored(const Stored& stored) {
  Map values, bindings;
  for (const auto& [key, value] : stored.values) values.emplace_back(key, packed(value, key));
  for (const auto& [action, names] : stored.bindings) bindings.emplace_back(action, List(names.begin(), names.end()));
  return Map{{"values", std::move(values)}, {"bindings", std::move(bindings)}};
}

Stored unpack_stored(const Value& value, const std::string& where) {
  if (!value.is<Map>()) fail(where, ": a table expected, got ", kind_name(value));
  Stored stored;
  for (const auto& [key, entry] : table(value, "values", where)) stored.values[key] = unpacked(entry, where + ": " + key);
  for (const auto& [action, names] : table(value, "bindings", where)) {
    const List* list = names.get<List>();
    if (!list) fail(where, ": bindings: ", action, ": a list expected, got ", kind_name(names));
    std::vector<std::string>& keys = stored.bindings[action];
    for (const Value& name : *list) {
      if (!name.is<std::string>()) fail(where, ": bindings: ", action, ": names expected, got ", text(name));
      keys.push_back(*name.get<std::string>());
    }
  }
  return stored;
}

std::string write_stored(const Stored& stored) {
  Value root = Map{{"tumble_storage", kVersion}};
  Value content = pack_stored(stored);
  for (auto& [key, value] : *content.get<Map>()) root[key] = std::move(value);
  return write_json(root);
}

Stored read_stored(const std::string& text, const std::string& file) {
  const Value root = parse_json(text, file);
  const Value* version = root.find("tumble_storage");
  if (!version) fail(file, ": no 'tumble_storage' in it; it is something else or was cut off");
  if (!(*version == Value(kVersion))) fail(file, ": of version ", tumble::text(*version), "; this runtime reads version ", kVersion);
  return unpack_stored(root, file);
}

// ---- one run

void Storage::begin(Stored stored) {
  first_ = now_ = std::move(stored);
  sizes_.clear();
  bytes_ = 0;
  changed_ = false;
  for (const auto& [key, value] : now_.values) bytes_ += sizes_[key] = key.size() + write_json(packed(value, key)).size();
}

void Storage::save(const std::string& key, const Value& value, const std::string& call) {
  if (key.empty() || !is_utf8(key)) fail(call, ": a key of at least one letter, in UTF-8, expected");
  const Value* before = load(key);
  if (before ? *before == value : value.is_nil()) return;
  const std::size_t size = value.is_nil() ? 0 : key.size() + write_json(packed(value, call + ": " + key)).size();
  const std::size_t others = bytes_ - sizes_[key];
  if (size > 0 && others + size > kMostBytes)
    fail(call, ": ", key, ": with it the game would store ", megabytes(others + size), "; it may store ", megabytes(kMostBytes),
         " in all: store less, or remove a key with storage.save(key, nil)");
  bytes_ = others + size;
  if (value.is_nil()) {
    now_.values.erase(key);
    sizes_.erase(key);
  } else {
    now_.values[key] = value;
    sizes_[key] = size;
  }
  changed_ = true;
}

void Storage::save_binding(const std::string& action, const std::vector<std::string>& names) {
  changed_ |= !now_.bindings.contains(action) || now_.bindings[action] != names;
  now_.bindings[action] = names;
}

void Storage::forget_binding(const std::string& action) { changed_ |= now_.bindings.erase(action) > 0; }

const Value* Storage::find(const Stored& stored, const std::string& key) {
  const auto found = stored.values.find(key);
  return found == stored.values.end() ? nullptr : &found->second;
}

bool Storage::take_changed() { return std::exchange(changed_, false); }

}  // namespace tumble
