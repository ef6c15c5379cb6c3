// Names in a game's texts that neither the engine nor the game knows.
#include <algorithm>

#include "base/text.h"
#include "script/check_parts.h"
#include "script/document.h"
#include "script/document_parts.h"

namespace tumble {

namespace {

const char* const kLuaWords[] = {
    "assert", "error", "ipairs", "pairs", "next", "pcall", "xpcall", "select", "tonumber", "tostring", "type", "setmetatable", "getmetatable", "rawequal", "rawget",
    "rawlen", "coroutine", "string", "table", "utf8", "math", "host", "self", "_ENV",
    // what is in them
    "create", "resume", "yield", "status", "wrap", "isyieldable", "running", "close", "byte", "char", "find", "format", "gmatch", "gsub", "len", "lower", "match", "rep",
    "reverse", "sub", "upper", "pack", "packsize", "unpack", "concat", "insert", "move", "remove", "sort", "codepoint", "codes", "offset", "charpattern", "n",
    "abs", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge", "log", "max", "min", "maxinteger", "mininteger", "modf", "pi", "rad", "random", "sin", "sqrt", "tan", "acos",
    "asin", "atan", "tointeger", "ult"};
const char* const kTestWords[] = {"test", "expect", "press", "release", "tap", "set_axis", "point_at", "click", "is_on_screen", "type_text", "turn_wheel"};
// What tables hold that the engine gives: physics.stats(), game.list().
const char* const kTableWords[] = {"bodies", "awake", "joints", "contacts", "islands", "substeps", "step_ms", "path", "about"};
const char* const kExpectations[] = {"equals", "near", "above", "below", "contains", "raises"};

std::vector<std::string> list_of(const std::set<std::string>& words) { return {words.begin(), words.end()}; }

// Words of some length that look like a name: numbers of a list of coins are none.
bool is_near_enough(const std::string& word) { return word.size() >= 3; }

// A name of one text that is read, though the text gives it nothing: a local of that name anywhere in the text counts.
std::set<std::string> names_of(const LuaText& text) {
  std::set<std::string> names;
  const std::vector<Token>& t = text.tokens;
  for (std::size_t i = 0; t[i].kind != Token::Kind::end; ++i) {
    if (t[i].is("local") || t[i].is("for") || t[i].is("function")) {
      std::size_t k = i + 1;
      if (t[k].is("function")) ++k;
      while (t[k].is_name() || t[k].is(",") || t[k].is("<") || t[k].is(">") || t[k].is(".") || t[k].is(":")) names.insert(t[k++].text);
      if (t[k].is("(") && !t[i].is("for"))
        while (t[k].kind != Token::Kind::end && !t[k].is(")")) names.insert(t[k++].text);
    }
  }
  return names;
}

void check_globals(const LuaText& text, const std::set<std::string>& globals, Check& check) {
  const std::set<std::string> own = names_of(text);
  std::set<std::string> known = globals;
  known.insert(own.begin(), own.end());
  std::set<std::string> told;
  const std::vector<Token>& t = text.tokens;
  for (std::size_t i = 0; t[i].kind != Token::Kind::end; ++i) {
    if (!t[i].is_name() || (i > 0 && (t[i - 1].is(".") || t[i - 1].is(":") || t[i - 1].is("goto") || t[i - 1].is("::")))) continue;
    const bool is_key = t[i + 1].is("=") && i > 0 && (t[i - 1].is("{") || t[i - 1].is(",") || t[i - 1].is(";"));
    if (is_key || known.count(t[i].text) || !told.insert(t[i].text).second) continue;
    const std::string near = did_you_mean(t[i].text, list_of(known));
    if (t[i + 1].is("=")) check.error(text.path, t[i].line, "'" + t[i].text + "' is not declared" + (near.empty() ? "; write local " + t[i].text + " at the top of the file" : near));
    else check.error(text.path, t[i].line, "unknown name '" + t[i].text + "'" + (near.empty() ? "; declare it with `local` above its first use" : near));
  }
}

// `.name` and `:name` that nothing gives a value to.
void check_fields(const LuaText& text, Check& check) {
  const std::vector<Token>& t = text.tokens;
  const std::vector<std::string> known = list_of(check.words);
  std::set<std::string> told;
  for (std::size_t i = 1; t[i].kind != Token::Kind::end; ++i) {
    if (!t[i].is_name() || !(t[i - 1].is(".") || t[i - 1].is(":")) || check.words.count(t[i].text) || !told.insert(t[i].text).second) continue;
    check.error(text.path, t[i].line, "'" + t[i - 1].text + t[i].text + "': neither the engine nor this game has a '" + t[i].text + "'" + did_you_mean(t[i].text, known));
  }
}

// Of each word: does it stand in braces that a function of the engine gets, and so has a meaning for the engine? What
// behaviours get is the game's own.
std::vector<bool> engine_tables(const std::vector<Token>& t, const std::set<std::string>& api) {
  std::vector<bool> marks(t.size());
  enum class Block { engine, other, function };
  std::vector<Block> open;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i].is("{")) {
      const std::size_t call = t[i - 1].is("(") && i > 1 ? i - 2 : i - 1;
      const bool to_engine = t[call].is_name() && call > 1 && t[call - 1].is(".") && api.count(t[call].text);
      const bool own = i > 1 && t[i - 1].is("=") && (t[i - 2].is("behaviours") || t[i - 2].is("physics"));
      const bool outermost = open.empty() || open.back() == Block::function;
      open.push_back(!own && (outermost ? to_engine : open.back() == Block::engine) ? Block::engine : Block::other);
    } else if (t[i].is("}") && !open.empty()) {
      open.pop_back();
    } else if (t[i].is("function")) {
      open.push_back(Block::function);
    } else if (t[i].is("end") && !open.empty() && open.back() == Block::function) {
      open.pop_back();            // at the first end, be it an if's: braces inside are outermost all the same
    }
    marks[i] = !open.empty() && open.back() == Block::engine;
  }
  return marks;
}

// A key in such braces that nobody reads and that is nearly a word of the engine: { volum = 1 }.
void check_keys(const LuaText& text, const std::set<std::string>& api, Check& check) {
  const std::vector<Token>& t = text.tokens;
  const std::vector<std::string> words = list_of(api);
  const std::vector<bool> in_table = engine_tables(t, api);
  for (std::size_t i = 1; t[i].kind != Token::Kind::end; ++i) {
    const bool is_key = in_table[i] && t[i].is_name() && t[i + 1].is("=") && (t[i - 1].is("{") || t[i - 1].is(",") || t[i - 1].is(";"));
    if (!is_key || api.count(t[i].text) || check.reads.count(t[i].text) || !is_near_enough(t[i].text)) continue;
    if (check.literals.count(t[i].text) || check.handlers.count(t[i].text)) continue;
    const std::string near = did_you_mean(t[i].text, words);
    if (!near.empty()) check.warn(text.path, t[i].line, "nothing reads the key '" + t[i].text + "'" + near);
  }
}

// A function that nobody calls and that is nearly a handler: function Update().
void check_handlers(const LuaText& text, const std::vector<std::string>& events, Check& check) {
  const std::vector<Token>& t = text.tokens;
  for (std::size_t i = 1; t[i].kind != Token::Kind::end; ++i) {
    if (!t[i].is_name() || !t[i + 1].is("(")) continue;
    const bool top = t[i - 1].is("function") && !(i > 1 && t[i - 2].is("local"));
    const bool method = t[i - 1].is(":") && i > 2 && t[i - 3].is("function");
    if (!top && !method) continue;
    const std::string& name = t[i].text;
    if (std::find(events.begin(), events.end(), name) != events.end() || check.reads.count(name)) continue;
    const auto uses = std::count_if(t.begin(), t.end(), [&](const Token& token) { return token.is_name() && token.text == name; });
    if (uses > 1) continue;
    if (name.starts_with("on_") && check.literals.count(name.substr(3))) continue;
    const std::string near = did_you_mean(name, events);
    if (!near.empty()) check.error(text.path, t[i].line, "nobody calls '" + name + "', and it is no event" + near);
  }
}

}  // namespace

std::set<std::string> api_words() {
  std::set<std::string> words(std::begin(kLuaWords), std::end(kLuaWords));
  words.insert(std::begin(kTableWords), std::end(kTableWords));
  words.insert(std::begin(kExpectations), std::end(kExpectations));
  for (const DocumentedName& entry : documented_names()) {
    words.insert(entry.name);
    words.insert(entry.area);
  }
  for (const Page& page : document_pages()) {
    std::vector<const Type*> types = page.tables;
    for (const Area* area : page.areas) {
      for (const Row& row : area->rows)
        for (const Param& param : row.params) words.insert(param.name);
      if (area->described) types.push_back(area->described);
    }
    for (std::size_t i = 0; i < types.size(); ++i) {
      for (const std::string& name : types[i]->field_names()) words.insert(name);
      for (const Type* inner : tables_within(*types[i]))
        if (std::find(types.begin(), types.end(), inner) == types.end()) types.push_back(inner);
    }
  }
  return words;
}

std::set<std::string> global_words() {
  std::set<std::string> words(std::begin(kLuaWords), std::begin(kLuaWords) + 24);
  for (const DocumentedName& entry : documented_names()) {
    if (entry.area == "globals") words.insert(entry.name);
    else if (!entry.object && entry.area != "handlers" && entry.area != "bot") words.insert(entry.area);
  }
  return words;
}

void check_words(Check& check) {
  const std::set<std::string> api = api_words(), globals = global_words();
  std::vector<std::string> events = {"start", "update", "late_update", "frame", "draw_ui"};
  for (const DocumentedName& entry : documented_names())
    if (entry.kind == DocumentedName::Kind::event) events.push_back(entry.name);
  for (const LuaText& text : check.texts) {
    if (text.of_engine) continue;
    std::set<std::string> known = globals;
    const bool plays = text.path == "bot.lua" || text.path.starts_with("tests/");
    if (plays) known.insert(std::begin(kTestWords), std::end(kTestWords));
    check_globals(text, known, check);
    check_fields(text, check);
    check_keys(text, api, check);
    if (!plays) check_handlers(text, events, check);
  }
}

// ---- luacheck

std::string check_config() {
  std::string modules;
  std::map<std::string, std::set<std::string>> fields;
  for (const DocumentedName& entry : documented_names())
    if (!entry.object && entry.area != "globals" && entry.area != "handlers" && entry.area != "bot" && entry.kind != DocumentedName::Kind::event && entry.area.find('.') == std::string::npos) fields[entry.area].insert(entry.name);
  for (const auto& [module, names] : fields) {
    modules += "    " + module + " = { fields = {";
    for (const std::string& name : names) modules += " " + name + " = { read_only = false, other_fields = true },";
    modules += " } },\n";
  }
  std::string globals;
  for (const std::string& word : global_words())
    if (!fields.count(word) && word != "self") globals += " \"" + word + "\",";
  for (const char* word : kTestWords) globals += std::string(" \"") + word + "\",";
  return "stds.tumble = {\n  read_globals = {" + globals + "\n" + modules + "  },\n}\nstd = \"lua54+tumble\"\nallow_defined_top = true\nmax_line_length = false\nself = false\n" +
         "ignore = { \"131\", \"212\", \"213\" }\n";
}

}  // namespace tumble
