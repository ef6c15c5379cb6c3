// The pages of docs/api: Markdown from rows and described structs.
#include <algorithm>
#include <sstream>

#include "base/text.h"
#include "script/document_parts.h"
#include "script/embedded.h"

namespace tumble {

namespace {

const char* const kGenerated = "<!-- Written by `tumble docs` from the table behind the bindings; change it there. -->\n\n";

// Text outside of code spans: `<` would begin HTML, and `|` would end a table's cell.
std::string escaped(const std::string& text, bool in_table) {
  std::string result;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if ((c == '<' && !code) || (c == '|' && in_table)) result += '\\';
    result += c;
  }
  return result;
}

std::string cell(const std::string& text) { return escaped(text, true); }
std::string code_cell(const std::string& text) { return cell('`' + text + '`'); }

// ---- rows

// What stands before the name: "node:", "scene.", nothing. A behaviour's events are methods, a node's are plain slots.
std::string prefix(const Area& area, const Row& row) {
  if (is_word_area(area) && (area.name == "globals" || area.name == "handlers" || area.name == "bot")) return "";
  const bool method = row.method || (area.name == "behaviour" && row.kind == Row::Kind::event);
  return area.name + (method ? ":" : ".");
}

std::string signature(const Area& area, const Row& row) {
  std::vector<std::string> names;
  for (const Param& param : row.params) names.push_back(param.name);
  std::string text = prefix(area, row) + row.name + "(" + join(names) + ")";
  if (!row.returns.empty()) text += " -> " + row.returns;
  return text;
}

// "origin: vec3, filter: filter (may be left out)".
std::string parameters(const Row& row) {
  std::vector<std::string> list;
  for (const Param& param : row.params)
    if (param.name != "...") list.push_back("`" + param.name + "`: " + param.type + (param.optional ? " (may be left out)" : ""));
  return join(list);
}

const char* permit_text(const Row& row) {
  switch (row.permit) {
    case Permit::always: return "";
    case Permit::write: return "Not in `frame`.";
    case Permit::act: return "Not at the top level of a file and not in `frame`.";
    case Permit::query: return "Not at the top level of a file.";
  }
  return "";
}

void write_function(std::ostream& out, const Area& area, const Row& row) {
  out << "### " << row.name << "\n\n`" << signature(area, row) << "`\n\n" << escaped(row.doc, false) << '\n';
  if (const std::string list = parameters(row); !list.empty()) out << '\n' << escaped(list, false) << ".\n";
  if (*permit_text(row)) out << '\n' << permit_text(row) << '\n';
  out << '\n';
}

std::vector<const Row*> rows_of(const Area& area, Row::Kind kind) {
  std::vector<const Row*> list;
  for (const Row& row : area.rows)
    if (row.kind == kind) list.push_back(&row);
  return list;
}

void write_area(std::ostream& out, const Area& area) {
  const std::string owner = (area.object ? "a " : "") + area.name;
  if (const auto rows = rows_of(area, Row::Kind::property); !rows.empty()) {
    out << "## Properties of " << owner << "\n\n| name | type | |\n|---|---|---|\n";
    for (const Row* row : rows)
      out << "| " << code_cell(row->name) << " | " << cell(row->returns) << (is_writable(*row) ? "" : ", read only") << " | " << cell(row->doc) << " |\n";
    out << '\n';
  }
  if (const auto rows = rows_of(area, Row::Kind::function); !rows.empty()) {
    out << (area.object ? "## Methods of " : "## Functions of ") << owner << "\n\n";
    for (const Row* row : rows) write_function(out, area, *row);
  }
  if (const auto rows = rows_of(area, Row::Kind::event); !rows.empty()) {
    out << "## Events of " << owner << "\n\n| write | called |\n|---|---|\n";
    for (const Row* row : rows) out << "| " << code_cell("function " + signature(area, *row)) << " | " << cell(row->doc) << " |\n";
    out << '\n';
  }
}

// ---- described structs

std::string number_in(double value, bool degrees_wanted) { return number_text(degrees_wanted ? degrees(value) : value); }

std::string bounds(const Field& field) {
  const bool low = field.minimum > -1e308, high = field.maximum < 1e308;
  if (low && high) return number_in(field.minimum, field.angle) + " to " + number_in(field.maximum, field.angle);
  if (low) return (field.above_minimum ? "above " : "at least ") + number_in(field.minimum, field.angle);
  if (high) return "at most " + number_in(field.maximum, field.angle);
  return "";
}

// The name that people write, and what it holds in an object as it is made.
void write_field(std::ostream& out, const Type& type, const void* made, const Field& field) {
  const bool rotation = field.angle && content_of(*field.type).kind == Kind::quat;
  const std::string name = field.angle ? field.name + "_degrees" : field.name;
  const Value value = *field_value(type, made, name);
  out << "| " << code_cell(name) << " | " << cell(rotation ? "vec3" : type_text(*field.type)) << " | "
      << (content_of(*field.type).kind == Kind::structure || value.is_nil() ? "" : code_cell(lua_text(value))) << " | " << bounds(field) << " | " << cell(field.doc);
  if (field.angle) out << " `" << field.name << "`: the same " << (rotation ? "as a quat." : "in radians.");
  out << " |\n";
}

void write_type(std::ostream& out, const Type& type, const std::string& title) {
  out << "## " << title << "\n\n" << escaped(type.summary, false) << "\n\n";
  if (!type.main_field.empty()) out << "A plain value stands for `" << type.main_field << "`.\n\n";
  if (type.fields.empty()) return;
  out << "| key | type | default | bounds | |\n|---|---|---|---|---|\n";
  const std::unique_ptr<void, std::function<void(void*)>> made(type.make(), type.drop);
  for (const Field& field : type.fields) write_field(out, type, made.get(), field);
  out << '\n';
}

bool has_own_page(const Type& type) {
  const auto& areas = all_areas();
  return std::any_of(areas.begin(), areas.end(), [&](const Area* area) { return area->described == &type; });
}

// The page's tables, each followed by those it contains, if they have no page of their own.
void write_tables(std::ostream& out, const Page& page) {
  std::vector<const Type*> written;
  const auto write = [&](const Type& type, const std::string& title) {
    if (std::find(written.begin(), written.end(), &type) != written.end()) return;
    written.push_back(&type);
    write_type(out, type, title);
  };
  for (const Type* type : page.tables) write(*type, "Table: " + type->name);
  for (const Type* type : page.tables)
    for (const Type* inner : tables_within(*type))
      if (!has_own_page(*inner)) write(*inner, "Table: " + inner->name);
}

}  // namespace

std::string markdown_page(const Page& page) {
  std::ostringstream out;
  out << kGenerated << "# " << page.title << "\n\n" << escaped(page.doc, false) << "\n\n";
  for (const Area* area : page.areas) {
    if (area->doc != page.doc) out << escaped(area->doc, false) << "\n\n";
    write_area(out, *area);
  }
  write_tables(out, page);
  if (!page.notes.empty()) out << "## Notes\n\n" << page.notes << '\n';
  std::string text = out.str();
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

// The index needs no more than what a page is about.
static std::string first_sentence(const std::string& doc) {
  const std::size_t end = doc.find(". ");
  return end == std::string::npos ? doc : doc.substr(0, end + 1);
}

std::string markdown_index(const std::vector<Page>& pages) {
  std::ostringstream out;
  out << kGenerated << "# The Lua API\n\nUnits are SI and radians; any other unit is in the name. `help(x)` prints a page in the running game.\n\n";
  for (const Page& page : pages) out << "- [" << page.title << "](" << page.name << ".md): " << escaped(first_sentence(page.doc), false) << '\n';
  out << "- [std](std.md): Behaviours and modules in Lua that come with Tumble.\n";
  return out.str();
}

// ---- scripts/std: each file begins with a comment that says how to use it, and declares its properties with comments

namespace {

std::string leading_comment(const std::string& text) {
  std::istringstream lines(text);
  std::string line, result;
  bool code = false;
  while (std::getline(lines, line) && line.starts_with("--")) {
    const std::string words = line.size() > 3 ? line.substr(3) : "";
    const bool indented = words.starts_with("  ");
    if (indented && !code) result += result.ends_with("\n\n") ? "```\n" : "\n```\n";
    if (!indented && code) result += words.empty() ? "```\n" : "```\n\n";
    code = indented;
    result += (indented ? words.substr(2) : escaped(words, false)) + '\n';
  }
  return result + (code ? "```\n" : "");
}

// From `= behaviour {` to its brace.
std::string declared_properties(const std::string& text) {
  const std::size_t at = text.find("= behaviour {\n");
  if (at == std::string::npos) return "";
  const std::size_t begin = text.find('\n', at) + 1, end = text.find("\n}", begin);
  return text.substr(begin, end - begin);
}

}  // namespace

std::string markdown_std() {
  std::ostringstream out;
  out << kGenerated << "# std\n\nBehaviours and modules in Lua, in `scripts/std`. A game uses them by name, and a file of the same name in the game goes before "
      << "them: copy one into the game to change it.\n";
  std::vector<std::string> paths;
  for (const std::string& path : embedded_scripts())
    if (path.starts_with("std/")) paths.push_back(path);
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths) {
    const std::string text(embedded_script(path));
    out << "\n## " << path.substr(4, path.size() - 8) << "\n\n" << leading_comment(text);
    if (const std::string list = declared_properties(text); !list.empty()) out << "\nIts properties:\n\n```lua\n" << list << "\n```\n";
  }
  return out.str();
}

}  // namespace tumble
