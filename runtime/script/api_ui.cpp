// ui.*: what scripts say in draw_ui(), handed to engine/ui.
#include <algorithm>

#include "base/text.h"
#include "engine/ui/ui.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

// An options table, read field by field: a kept one costs no memory.
template <class T>
struct UiOptions { T value; };

template <class T>
struct LuaType<UiOptions<T>> {
  static constexpr bool optional = true;
  static std::string name() { return type_of<T>().name + " options"; }
  static UiOptions<T> read(Arguments& a) {
    UiOptions<T> options;
    ++a.number;
    const int table = a.index++;
    if (lua_isnoneornil(a.L, table)) return options;
    if (!lua_istable(a.L, table)) {
      a.index = table;
      a.bad("table");
    }
    const Type& type = type_of<T>();
    const std::string call = a.row.full_name();
    for (lua_pushnil(a.L); lua_next(a.L, table); lua_pop(a.L, 1)) {
      if (lua_type(a.L, -2) != LUA_TSTRING) fail(call, ": names of options expected, got ", describe_argument(a.L, -2), "; write ", call, "(..., { width = 300 })");
      const std::string key = lua_tostring(a.L, -2);
      if (!assign_field(type, &options.value, key, value_from_lua(a.L, -1, call), call)) {
        std::string hint = did_you_mean(key, type.field_names());
        fail(call, ": no option '", key, "'", hint.empty() ? "; known: " + join(type.field_names()) : hint);
      }
    }
    return options;
  }
};

namespace {

Ui& open_ui(Script& s, const char* call) {
  if (s.ui().is_open()) return s.ui();
  if (s.phase() == Phase::declare) s.refuse_declaration();
  fail(call, ": only in draw_ui(), which says what is on the screen in each tick; put it into function draw_ui() ... end");
}

std::string words_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = luaL_tolstring(L, index, &size);
  std::string words(text, size);
  lua_pop(L, 1);
  return words;
}

void ui_text(Script& s, Anything words, UiOptions<UiTextOptions> o) { open_ui(s, "ui.text").text(words_at(s.stack(), words.index), o.value); }
void space(Script& s, double amount) {
  if (amount < 0) fail("ui.space: height must be at least 0 (got ", number_text(amount), ")");
  open_ui(s, "ui.space").space(amount);
}
void bar(Script& s, double fraction, UiOptions<UiBarOptions> o) { open_ui(s, "ui.bar").bar(fraction, o.value); }
void box(Script& s, UiOptions<UiBoxOptions> o) { open_ui(s, "ui.box").box(o.value); }

void image(Script& s, std::string file, UiOptions<UiImageOptions> o) {
  AssetLibrary* assets = s.live_engine().assets;
  const Image* picture = assets ? assets->image(file) : nullptr;
  const bool known = picture && picture->width > 0 && picture->height > 0;
  open_ui(s, "ui.image").image(file, known ? picture->width : 128, known ? picture->height : 128, o.value);
}

bool button(Script& s, std::string label, UiOptions<UiWidgetOptions> o) { return open_ui(s, "ui.button").button(label, o.value); }
bool toggle(Script& s, std::string label, bool on, UiOptions<UiWidgetOptions> o) { return open_ui(s, "ui.toggle").toggle(label, on, o.value); }
double slider(Script& s, std::string label, double value, UiOptions<UiSliderOptions> o) { return open_ui(s, "ui.slider").slider(label, value, o.value); }

std::tuple<std::optional<int>, bool> list(Script& s, Anything given, std::optional<int> selected, UiOptions<UiListOptions> o) {
  lua_State* L = s.stack();
  if (!lua_istable(L, given.index)) fail("ui.list: items: a list of texts expected, got ", describe_argument(L, given.index));
  std::vector<std::string> items;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, given.index));
  for (lua_Integer i = 1; i <= count; ++i) {
    const int type = lua_rawgeti(L, given.index, i);
    if (type != LUA_TSTRING && type != LUA_TNUMBER) fail("ui.list: items[", i, "]: a text or number expected, got ", describe_argument(L, -1));
    items.push_back(words_at(L, -1));
    lua_pop(L, 1);
  }
  if (!o.value.id) o.value.id = "list";
  const auto [now, chosen] = open_ui(s, "ui.list").list(items, selected.value_or(0), o.value);
  return {now > 0 ? std::optional(now) : std::nullopt, chosen};
}

std::tuple<std::string, bool> field(Script& s, std::string label, std::string text, UiOptions<UiFieldOptions> o) {
  return open_ui(s, "ui.field").field(label, text, o.value);
}

// The new name takes the place of the action's names of the same device, so that keys and pad keep one each.
std::vector<std::string> rebound(const std::vector<std::string>& names, const std::string& name) {
  const auto is_pad = [](const std::string& raw) { return raw.starts_with("pad"); };
  std::vector<std::string> result;
  bool placed = false;
  for (const std::string& old : names) {
    if (is_pad(old) != is_pad(name)) result.push_back(old);
    else if (!std::exchange(placed, true)) result.push_back(name);
  }
  if (!placed) result.push_back(name);
  return result;
}

bool key(Script& s, std::string label, std::string action, UiOptions<UiWidgetOptions> o) {
  InputMap& input = s.live_engine().input;
  const auto found = input.actions().find(action);
  if (found == input.actions().end()) {
    std::vector<std::string> all;
    for (const auto& entry : input.actions()) all.push_back(entry.first);
    fail("ui.key: no action '", action, "' in game.json", did_you_mean(action, all));
  }
  const auto name = open_ui(s, "ui.key").key(label, found->second, o.value);
  if (name) input.bind(action, rebound(found->second, *name));
  return name.has_value();
}

void style(Script& s, Value options) {
  if (!options.is<Map>()) fail("ui.style: a table expected, got ", tumble::text(options), "; write ui.style { accent = \"gold\" }");
  assign(s.settings().ui, options, "ui.style");
}
void focus(Script& s, std::optional<std::string> label) { s.ui().focus(label.value_or("")); }
std::optional<std::string> focused(Script& s) { return s.ui().focused().empty() ? std::nullopt : std::optional(s.ui().focused()); }

// The content runs between opening and closing, outside of C++'s own frames, since an error in it leaves by a jump.
int run_content(lua_State* L, int function, int depth) {
  lua_pushvalue(L, function);
  lua_call(L, 0, 0);
  script_of(L).ui().close(depth);
  return 0;
}

int panel(lua_State* L) {
  int depth = 0;
  at_border(L, [L, &depth] {
    if (!lua_istable(L, 1)) fail("ui.panel: argument 1 (options): table expected, got ", describe_argument(L, 1), "; write ui.panel({ at = \"center\" }, function() ... end)");
    if (!lua_isfunction(L, 2)) fail("ui.panel: argument 2 (content): function expected, got ", describe_argument(L, 2));
    static Row row = [] {
      Row r;
      r.area = "ui";
      r.name = "panel";
      return r;
    }();
    Arguments arguments{L, script_of(L), row, 1, 0};
    const auto options = LuaType<UiOptions<UiPanelOptions>>::read(arguments);
    depth = open_ui(script_of(L), "ui.panel").open_panel(options.value);
    return 0;
  });
  return run_content(L, 2, depth);
}

int row(lua_State* L) {
  int depth = 0;
  at_border(L, [L, &depth] {
    if (!lua_isfunction(L, 1)) fail("ui.row: argument 1 (content): function expected, got ", describe_argument(L, 1));
    depth = open_ui(script_of(L), "ui.row").open_row();
    return 0;
  });
  return run_content(L, 1, depth);
}

double width(Script& s) { return kUiHeight * s.aspect; }
double height(Script&) { return kUiHeight; }

}  // namespace

const std::vector<const Type*>& ui_option_types() {
  static const std::vector<const Type*> types = {
      &type_of<UiStyle>(),      &type_of<UiTextOptions>(), &type_of<UiWidgetOptions>(), &type_of<UiSliderOptions>(), &type_of<UiListOptions>(),
      &type_of<UiFieldOptions>(), &type_of<UiBarOptions>(),  &type_of<UiBoxOptions>(),    &type_of<UiImageOptions>(),  &type_of<UiPanelOptions>()};
  return types;
}

void rows_ui(Area& a) {
  a.fn<ui_text>("text", "Writes a text; line feeds begin new lines.", "text", "options");
  a.fn<button>("button", "A button; true in the tick in which it was pressed: let go over it, or enter, space or pad_a.", "label", "options");
  a.fn<toggle>("toggle", "A switch; the state that it has now: volume_on = ui.toggle(\"Sound\", volume_on).", "label", "on", "options");
  a.fn<slider>("slider", "A slider; the value that it has now: volume = ui.slider(\"Volume\", volume).", "label", "value", "options");
  a.fn<list>("list", "A list of texts; which one is selected now, and true in the tick in which it was clicked or chosen with enter. Wheel and arrows scroll it.", "items", "selected", "options");
  a.fn<field>("field", "A line to write in; its text now, and true in the tick in which enter ended it.", "label", "text", "options");
  a.fn<key>("key", "The keys of an action. Press it, then the key that it shall have (escape: as before); true in the tick in which it changed.", "label", "action", "options");
  a.fn<bar>("bar", "A bar that is filled to a fraction.", "fraction", "options");
  a.fn<box>("box", "A filled rectangle.", "options");
  a.fn<image>("image", "A picture of the game's folder, as large as it is unless told otherwise.", "file", "options");
  a.fn<space>("space", "Leaves a space; in a row it is a width.", "height");
  a.raw("panel", "What content() names stands in it, one below the other.", panel, {{"options", "ui_panel options"}, {"content", "function"}}, "");
  a.raw("row", "What content() names stands side by side; buttons, sliders and bars share what is left.", row, {{"content", "function"}}, "");
  a.fn<style>("style", "How everything looks that says nothing else: ui.style { accent = \"gold\" }.", "options").writes().takes(0, "ui_style options");
  a.fn<focus>("focus", "Gives the focus of keys and pads to the widget with that id (its label, where it has none); without one to the first that is drawn.", "id").acts();
  a.prop<focused>("focused", "The id of the widget that has the focus of keys and pads.");
  a.prop<width>("width", "The screen's width in ui units: 1280 at 16:9.");
  a.prop<height>("height", "The screen's height in ui units: always 720.");
}

}  // namespace tumble
