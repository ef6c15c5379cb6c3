#include "script/document.h"

#include <algorithm>

#include "base/text.h"
#include "engine/node_def.h"
#include "engine/settings.h"
#include "physics/joint.h"
#include "script/areas.h"
#include "script/document_parts.h"

namespace tumble {

namespace {

const char* const kJointNotes =
    "Every joint also takes `name`, by which `node:joint(name)` finds it, `a` and `b`, the two nodes (`b` left out: the "
    "world), and `world_anchor` and `world_axis` instead of `anchor` and `axis`. A joint does nothing until both bodies are there "
    "and enabled; it goes with the first of them. All options can be read and written live, and writing wakes both bodies.\n\n"
    "Freedoms that have a table of their own (`slide`, `turn`, `turn_a`, `turn_b`, `swing_a`, `swing_b`, `twist`) also tell where "
    "they are: `joint.slide.position` (m), `joint.twist.angle` (rad) or `angle_degrees`, and `speed` (m/s or rad/s). A "
    "hinge and a slider have the options of their freedom, and what it tells, on the joint itself.\n";

const char* const kFilterNotes =
    "A filter is a table, or what `physics.filter` made of one: `{ groups = { \"walls\" }, tags = { \"coin\" }, ignore = node, "
    "only = node, triggers = false, accept = function(node) return true end }`. Every key may be left out; lists may be a "
    "single word or node.\n\nThe table is the key `physics` of [game.json](game_json.md).\n";

bool has_content(const Area& area) { return !area.rows.empty() || area.described; }

void add_area(std::vector<Page>& pages, const Area& area) {
  if (!has_content(area)) return;
  auto page = std::find_if(pages.begin(), pages.end(), [&](const Page& p) { return p.name == area.name; });
  if (page == pages.end()) {
    page = pages.insert(pages.end(), Page{});
    page->name = page->title = area.name;
    page->doc = area.doc;
  }
  page->areas.push_back(&area);
  if (area.described) page->tables.push_back(area.described);
}

Page& page_of(std::vector<Page>& pages, const char* name) {
  for (Page& page : pages)
    if (page.name == name) return page;
  fail("document: no page '", name, "'");
}

}  // namespace

std::vector<Page> document_pages() {
  std::vector<Page> pages;
  for (const Area& area : word_areas())
    if (!area.object) add_area(pages, area);
  for (const Area* area : all_areas()) add_area(pages, *area);
  for (const Area& area : word_areas())
    if (area.object) add_area(pages, area);

  page_of(pages, "node").tables.push_back(&type_of<NodeDef>());
  Page& joint = page_of(pages, "joint");
  joint.tables.push_back(&type_of<JointDef>());
  for (const std::string& kind : joint_kind_names()) joint.tables.push_back(&joint_kind_type(joint_kind(kind)));
  joint.notes = kJointNotes;
  page_of(pages, "physics").notes = kFilterNotes;
  page_of(pages, "ui").tables = ui_option_types();

  Page& settings = pages.emplace_back();
  settings.name = "game_json";
  settings.title = "game.json";
  settings.doc = "The file that makes a folder a game. Every key may be left out, and so may the file.";
  settings.tables.push_back(&type_of<GameSettings>());
  return pages;
}

const Type& content_of(const Type& type) { return type.element ? content_of(*type.element) : type; }

std::vector<const Type*> tables_within(const Type& type) {
  std::vector<const Type*> found;
  const auto visit = [&](const auto& self, const Type& outer) -> void {
    for (const Field& field : outer.fields) {
      const Type& inner = content_of(*field.type);
      if (inner.kind != Kind::structure || &inner == &type || std::find(found.begin(), found.end(), &inner) != found.end()) continue;
      found.push_back(&inner);
      self(self, inner);
    }
  };
  visit(visit, type);
  return found;
}

bool is_writable(const Row& row) { return row.set || row.permit == Permit::write; }

std::string lua_text(const Value& value) {
  if (const bool* b = value.get<bool>()) return *b ? "true" : "false";
  if (value.is_number()) return std::isinf(value.number()) ? "math.huge" : number_text(value.number());
  if (const std::string* s = value.get<std::string>()) return '"' + *s + '"';
  if (const Vec3* v = value.get<Vec3>()) return "vec3(" + number_text(v->x) + ", " + number_text(v->y) + ", " + number_text(v->z) + ")";
  if (const Quat* q = value.get<Quat>()) return *q == Quat{} ? "quat.identity" : "quat";
  if (const Color* c = value.get<Color>()) return '"' + to_hex(*c) + '"';
  if (value.is<List>() || value.is<Map>()) return "{}";
  return "nil";
}

std::vector<DocumentedName> documented_names() {
  std::vector<DocumentedName> names;
  for (const Page& page : document_pages())
    for (const Area* area : page.areas) {
      DocumentedName entry{area->name, area->object, is_word_area(*area), {}, ""};
      for (const Row& row : area->rows) {
        entry.kind = row.kind == Row::Kind::function   ? DocumentedName::Kind::function
                     : row.kind == Row::Kind::property ? DocumentedName::Kind::property
                                                       : DocumentedName::Kind::event;
        entry.name = row.name;
        names.push_back(entry);
      }
      entry.kind = DocumentedName::Kind::field;
      for (const std::string& name : area->object && area->described ? area->described->field_names() : std::vector<std::string>()) {
        entry.name = name;
        names.push_back(entry);
      }
    }
  return names;
}

std::vector<std::pair<std::string, std::string>> document_files() {
  const std::vector<Page> pages = document_pages();
  std::vector<std::pair<std::string, std::string>> files;
  files.emplace_back("docs/api/README.md", markdown_index(pages));
  for (const Page& page : pages) files.emplace_back("docs/api/" + page.name + ".md", markdown_page(page));
  files.emplace_back("docs/api/std.md", markdown_std());
  for (const Page& page : pages) files.emplace_back("scripts/types/" + page.name + ".d.lua", lua_types(page));
  return files;
}

}  // namespace tumble
