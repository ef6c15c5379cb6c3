#include "script/bind.h"

#include "base/text.h"
#include "script/script.h"

namespace tumble {

const Row* Area::find(std::string_view name) const {
  for (const Row& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

std::vector<std::string> Area::names() const {
  std::vector<std::string> list;
  for (const Row& row : rows) list.push_back(row.name);
  if (described)
    for (const std::string& name : described->field_names())
      if (!find(name)) list.push_back(name);
  return list;
}

Row& Area::event(const char* name, const char* doc, std::vector<Param> params) {
  Row& row = raw(name, doc, nullptr, std::move(params), "");
  row.kind = Row::Kind::event;
  return row;
}

Row& Area::scripted(const char* name, const char* doc, std::vector<Param> params, const char* returns) {
  Row& row = raw(name, doc, nullptr, std::move(params), returns);
  row.scripted = true;
  return row;
}

Row& Area::raw(const char* name, const char* doc, lua_CFunction call, std::vector<Param> params, const char* returns) {
  Row& row = rows.emplace_back();
  row.area = this->name;
  row.name = name;
  row.doc = doc;
  row.call = call;
  row.params = std::move(params);
  row.returns = returns;
  return row;
}

void raise(lua_State* L) {
  // The nearest line of the game; lines of boot mean nothing to its author.
  lua_Debug record;
  lua_pushliteral(L, "");
  for (int level = 1; lua_getstack(L, level, &record); ++level) {
    lua_getinfo(L, "Sl", &record);
    if (record.source[0] != '@' || record.currentline < 0 || std::string_view(record.source).starts_with("@boot/")) continue;
    lua_pushfstring(L, "%s:%d: ", record.source + 1, record.currentline);
    lua_replace(L, -2);
    break;
  }
  lua_rotate(L, -2, 1);
  lua_concat(L, 2);
  lua_error(L);
  std::abort();  // lua_error does not return, but does not say so
}

void check_permit(Script& script, const Row& row) {
  const Phase phase = script.phase();
  if (phase == Phase::declare && (row.permit == Permit::act || row.permit == Permit::query)) {
    script.refuse_declaration();
    fail(row.full_name(), ": not at the top level of a file, which runs again at every save; put it in start()");
  }
  if (phase == Phase::frame && (row.permit == Permit::act || row.permit == Permit::write))
    fail(row.full_name(), ": frame only draws; change things in update or late_update");
  if (phase == Phase::watch && (row.permit == Permit::act || row.permit == Permit::write))
    fail(row.full_name(), ": a bot may read everything but change only its input");
}

}  // namespace tumble
