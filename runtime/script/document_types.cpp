// scripts/types: the API for the Lua language server. Objects are classes by their names; an options table of a
// described struct is the class <name>_options.
#include <algorithm>
#include <sstream>

#include "base/text.h"
#include "script/document_parts.h"

namespace tumble {

namespace {

// Options tables that are not described structs; fields as the language server writes them.
const char* const kFilterOptions = R"(---@class filter_options
---@field groups? string|string[]
---@field tags? string|string[]
---@field ignore? node|node[]
---@field only? node|node[]
---@field triggers? boolean
---@field accept? fun(node: node): boolean
)";
const char* const kJointOptions = R"(---@field name? string
---@field a? node
---@field b? node
---@field world_anchor? vec3
---@field world_axis? vec3
)";
// What a freedom tells beside its options.
const char* const kSlideState = R"(---@field position? number Where it is, m; to be read.
---@field speed? number How fast that changes, m/s; to be read.
)";
const char* const kTurnState = R"(---@field angle? number Where it is, rad; to be read.
---@field angle_degrees? number The same in degrees.
---@field speed? number How fast that changes, rad/s; to be read.
)";
const char* const kNodeOptions = R"(---@field parent? node
)";
const char* const kExpectation = R"(---@class expectation
---@field equals fun(self: expectation, other: any)
---@field near fun(self: expectation, other: any, tolerance: number)
---@field above fun(self: expectation, other: any)
---@field below fun(self: expectation, other: any)
---@field contains fun(self: expectation, part: any)
---@field raises fun(self: expectation, text: string)
)";

// ---- types

// A field's type in an options table, where short forms are allowed too.
std::string written_type(const Type& type) {
  switch (type.kind) {
    case Kind::choice: return '"' + join(type.choices, "\"|\"") + '"';
    case Kind::color: return "color|string";
    case Kind::structure: return type.name + "_options" + (type.main_field.empty() ? "" : "|string");
    case Kind::optional: return written_type(*type.element);
    case Kind::list: return "(" + written_type(*type.element) + ")[]|" + written_type(*type.element);
    case Kind::map: return "table<string, " + written_type(*type.element) + ">";
    default: return type.name;
  }
}

// A row's type as the documents word it: "hit or nil", "list of node", "hinge options".
std::string row_type(const std::string& text, bool given) {
  if (text.ends_with(" or nil")) return row_type(text.substr(0, text.size() - 7), given) + "?";
  if (text.starts_with("list of ")) return row_type(text.substr(8), given) + "[]";
  if (text == "node table") return "node_options";
  if (text.ends_with(" options")) return text.substr(0, text.size() - 8) + "_options";
  if (text == "collider") return "collider_options";
  if (text == "shape") return "shape_options|string";
  if (text == "list") return "any[]";
  if (text == "..." || text == "component" || text == "property") return "any";
  if (given && text == "filter") return "filter|filter_options";
  if (given && text == "color") return "color|string";
  return text;
}

// "number, number, number" is three values.
std::string returned_types(const std::string& text) {
  std::string result;
  std::istringstream parts(text);
  std::string part;
  while (std::getline(parts, part, ','))
    result += (result.empty() ? "" : ", ") + row_type(part.substr(part.find_first_not_of(' ')), false);
  return result;
}

// What may be assigned to a property: a component takes a table or its main field's word.
std::string property_type(const Row& row) {
  const bool or_nil = row.returns.ends_with(" or nil");
  const std::string name = or_nil ? row.returns.substr(0, row.returns.size() - 7) : row.returns;
  if (is_writable(row))
    for (const Area* area : all_areas())
      if (area->object && area->described && area->name == name) return name + "|" + written_type(*area->described);
  return row_type(row.returns, is_writable(row));
}

// ---- functions

void write_doc(std::ostream& out, const std::string& doc) { out << "--- " << doc << '\n'; }

std::string parameter_names(const Row& row) {
  std::vector<std::string> names;
  for (const Param& param : row.params) names.push_back(param.name);
  return join(names);
}

std::string parameter_list(const Row& row, bool as_numbers) {
  std::vector<std::string> list;
  for (const Param& param : row.params) {
    const std::string mark = param.optional && param.name != "..." ? "?" : "";
    if (as_numbers && param.type == "vec3" && mark.empty())
      for (const char* axis : {"_x", "_y", "_z"}) list.push_back(param.name + axis + ": number");
    else
      list.push_back(param.name + mark + ": " + row_type(param.type, true));
  }
  return join(list);
}

std::string function_type(const Row& row, const std::string& self, bool as_numbers) {
  const std::string list = parameter_list(row, as_numbers);
  return "fun(" + self + (self.empty() || list.empty() ? "" : ", ") + list + ")" + (row.returns.empty() ? "" : ": " + returned_types(row.returns));
}

void write_function(std::ostream& out, const Area& area, const Row& row, const std::string& owner) {
  write_doc(out, row.doc);
  bool takes_vec3 = false;
  for (const Param& param : row.params) {
    const bool rest = param.name == "...";
    out << "---@param " << param.name << (param.optional && !rest ? "? " : " ") << row_type(param.type, true) << '\n';
    takes_vec3 |= param.type == "vec3" && !param.optional;
  }
  if (!row.returns.empty()) out << "---@return " << returned_types(row.returns) << '\n';
  if (takes_vec3) out << "---@overload " << function_type(row, row.method ? "self: " + area.name : "", true) << '\n';
  out << "function " << owner << (owner.empty() ? "" : row.method ? ":" : ".") << row.name << "(" << parameter_names(row) << ") end\n\n";
}

// ---- classes

void write_field_lines(std::ostream& out, const Type& type, const Area* area, bool optional) {
  for (const Field& field : type.fields) {
    const std::string mark = optional || field.type->kind == Kind::optional ? "?" : "";
    if (!area || !area->find(field.name)) out << "---@field " << field.name << mark << ' ' << written_type(*field.type) << ' ' << field.doc << '\n';
    const std::string twin = field.name + "_degrees";
    if (field.angle && (!area || !area->find(twin)))
      out << "---@field " << twin << mark << (content_of(*field.type).kind == Kind::quat ? " vec3" : " number") << " The same in degrees.\n";
  }
}

void write_options(std::ostream& out, const Type& type, bool of_joint) {
  out << "--- " << type.summary << "\n---@class " << type.name << "_options" << (of_joint && type.name != "joint" ? ": joint_options" : "") << '\n';
  write_field_lines(out, type, nullptr, true);
  if (type.name == "joint") out << kJointOptions;
  if (type.name == "slide") out << kSlideState;
  if (type.name == "turn" || type.name == "swing") out << kTurnState;
  if (type.name == "node") out << kNodeOptions;
  out << '\n';
}

const char* operators(const std::string& name) {
  if (name == "vec3")
    return "---@operator add(vec3): vec3\n---@operator sub(vec3): vec3\n---@operator mul(number): vec3\n---@operator mul(vec3): vec3\n"
           "---@operator div(number): vec3\n---@operator div(vec3): vec3\n---@operator unm: vec3\n";
  if (name == "quat") return "---@operator mul(vec3): vec3\n---@operator mul(quat): quat\n";
  return "";
}

// What calling the module itself makes.
const char* constructor(const std::string& name) {
  if (name == "vec3") return "---@overload fun(x: number, y: number, z: number): vec3\n";
  if (name == "color") return "---@overload fun(r: number, g: number, b: number, a?: number): color\n---@overload fun(name: string): color\n";
  return "";
}

bool is_handlers(const Area& area) { return is_word_area(area) && area.name == "handlers"; }
bool is_global(const Area& area) { return is_word_area(area) && (area.name == "globals" || area.name == "bot"); }

void write_class(std::ostream& out, const Area& area) {
  write_doc(out, area.doc);
  out << "---@class " << (area.object || is_handlers(area) ? area.name : area.name + "_module")
      << (area.object && area.name == "joint" ? ": hinge_options, slider_options, cylindrical_options, universal_options, ragdoll_options" : "") << '\n';
  if (area.object) out << operators(area.name);
  else if (is_word_area(area)) out << constructor(area.name);
  for (const Row& row : area.rows) {
    if (row.kind == Row::Kind::property) out << "---@field " << row.name << ' ' << property_type(row) << ' ' << row.doc << '\n';
    if (row.kind == Row::Kind::event) {
      const bool method = area.name == "behaviour";
      out << "---@field " << row.name << "? " << function_type(row, method ? "self: behaviour" : "", false) << ' ' << row.doc << '\n';
    }
  }
  if (area.object && area.described) write_field_lines(out, *area.described, &area, false);
  if (area.object && area.name == "behaviour") out << "---@field [string] any\n";
}

void write_area(std::ostream& out, const Area& area) {
  const bool global = is_global(area);
  // Lua's own math and require stay as the language server knows them; math gets a few more functions.
  const bool extends = is_word_area(area) && area.name == "math";
  if (!global && !extends) {
    write_class(out, area);
    if (!is_handlers(area)) out << (area.object ? "local " : "") << area.name << " = {}\n";
    out << '\n';
  }
  for (const Row& row : area.rows) {
    const bool lua_has_it = global && (row.name == "require" || row.name == "print");
    if (row.kind == Row::Kind::function && !lua_has_it) write_function(out, area, row, global ? "" : area.name);
  }
}

}  // namespace

std::string lua_types(const Page& page) {
  std::ostringstream out;
  out << "---@meta\n-- Written by `tumble docs` from the table behind the bindings; change it there.\n\n";
  for (const Area* area : page.areas) write_area(out, *area);
  std::vector<const Type*> list;
  for (const Type* type : page.tables) {
    list.push_back(type);
    for (const Type* inner : tables_within(*type)) list.push_back(inner);
  }
  std::vector<const Type*> written;
  for (const Type* type : list) {
    const bool elsewhere = std::any_of(all_areas().begin(), all_areas().end(), [&](const Area* area) {
      return area->described == type && area->name != page.name;
    });
    if (elsewhere || std::find(written.begin(), written.end(), type) != written.end()) continue;
    written.push_back(type);
    write_options(out, *type, page.name == "joint" && std::find(page.tables.begin(), page.tables.end(), type) != page.tables.end());
  }
  if (page.name == "physics") out << kFilterOptions;
  if (page.name == "bot") out << kExpectation;
  std::string text = out.str();
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace tumble
