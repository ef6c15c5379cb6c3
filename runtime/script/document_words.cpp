// What scripts can say that has no rows, since scripts/boot or Lua itself provides it. test_generated.cpp walks these
// against a living game, so that neither has a name which the other lacks.
#include "script/document_parts.h"

namespace tumble {

namespace {

Row& property(Area& area, const char* name, const char* type, const char* doc, bool writable = false) {
  Row& row = area.raw(name, doc, nullptr, {}, type);
  row.kind = Row::Kind::property;
  row.permit = writable ? Permit::write : Permit::always;
  return row;
}

void method(Area& area, const char* name, const char* doc, std::vector<Param> params, const char* returns = "") {
  area.scripted(name, doc, std::move(params), returns).method = true;
}

const Param kRest{"...", "any", true};

void fill_globals(Area& a) {
  a.scripted("behaviour", "Declares a behaviour and its properties, each typed by its default; a behaviour's file returns it.",
             {{"properties", "table", true}}, "behaviour");
  a.scripted("tween", "Leads fields of a node, component, joint, behaviour or table to goals, in some seconds. Options: ease (\"linear\" \"in\" "
             "\"out\" \"in_out\" \"out_back\" \"out_bounce\"), delay, back, times. A new tween of a field replaces the old one.",
             {{"target", "any"}, {"seconds", "number"}, {"goals", "table"}, {"options", "table", true}}, "task").acts();
  a.scripted("wait", "In a task: goes on after that many seconds of game time.", {{"seconds", "number"}});
  a.scripted("wait_until", "In a task: goes on when condition() is true; false if the time was up first.",
             {{"condition", "function"}, {"timeout", "number", true}}, "boolean");
  a.scripted("require", "What another file returns: from the game's folder, else from scripts/std. Only at the top of a file.", {{"name", "string"}}, "any");
  a.scripted("print", "A line for the author, in the terminal and over the game.", {kRest});
  a.scripted("help", "Prints the page of a module or object.", {{"x", "any"}});
}

void fill_math(Area& a) {
  a.scripted("clamp", "The number, but at least low and at most high.", {{"x", "number"}, {"low", "number"}, {"high", "number"}}, "number");
  a.scripted("lerp", "The number at t on the way: 0 is a, 1 is b.", {{"a", "number"}, {"b", "number"}, {"t", "number"}}, "number");
  a.scripted("round", "The nearest whole number; halves go away from zero.", {{"x", "number"}}, "number");
  a.scripted("sign", "-1, 0 or 1.", {{"x", "number"}}, "number");
  a.scripted("approach", "The value, brought nearer to the goal by at most a step.", {{"value", "number"}, {"goal", "number"}, {"step", "number"}}, "number");
}

void fill_vec3(Area& a) {
  for (const auto& [name, doc] : std::initializer_list<std::pair<const char*, const char*>>{
           {"zero", "0, 0, 0."}, {"one", "1, 1, 1."}, {"up", "0, 1, 0."}, {"down", "0, -1, 0."}, {"left", "-1, 0, 0."},
           {"right", "1, 0, 0."}, {"forward", "0, 0, -1."}, {"back", "0, 0, 1."}})
    property(a, name, "vec3", doc);
}

void fill_quat(Area& a) {
  property(a, "identity", "quat", "No rotation.");
  a.scripted("axis_angle", "A turn about an axis, right-handed.", {{"axis", "vec3"}, {"radians", "number"}}, "quat");
  a.scripted("euler_degrees", "From Euler angles, turned first about y, then x, then z.", {{"x", "number"}, {"y", "number"}, {"z", "number"}}, "quat");
  a.scripted("look", "The rotation whose forward (-z) points there.", {{"forward", "vec3"}, {"up", "vec3", true}}, "quat");
}

void fill_color(Area& a) {
  a.scripted("hsv", "From hue, saturation and value, each 0 to 1.", {{"h", "number"}, {"s", "number"}, {"v", "number"}}, "color");
}

void input_events(Area& a) {
  a.event("on_press", "A key or button went down: first its raw name, then each action it belongs to. Also while paused.", {{"name", "string"}});
  a.event("on_release", "It went up.", {{"name", "string"}});
  a.event("on_pointer_move", "The pointer moved, in ui units.", {{"dx", "number"}, {"dy", "number"}});
  a.event("on_wheel", "The wheel turned, away from you.", {{"steps", "number"}});
  a.event("on_text", "Text was typed, with whatever input method the person uses; it is on only where something has this function.", {{"text", "string"}});
}

void fill_handlers(Area& a) {
  a.event("start", "Once, after the files have run.", {});
  a.event("on_scene_start", "After each load or restart of a scene.", {{"name", "string"}});
  a.event("update", "Each tick.", {{"dt", "number"}});
  a.event("late_update", "Each tick after physics and its events: cameras, followers.", {{"dt", "number"}});
  a.event("frame", "Each drawn frame; it draws and changes nothing.", {{"dt", "number"}});
  a.event("draw_ui", "Each tick, also while paused: the place for ui calls.", {});
  input_events(a);
  a.event("on_reload", "After changed files were taken over.", {});
}

void fill_behaviour(Area& a) {
  property(a, "node", "node", "The node that it is on.");
  property(a, "enabled", "boolean", "Off: it gets no updates and its tasks stand still.", true);
  a.event("start", "At the end of the tick in which it came, parents first.", {});
  a.event("update", "Each tick, in tree order.", {{"dt", "number"}});
  a.event("late_update", "Each tick after physics and its events.", {{"dt", "number"}});
  a.event("frame", "Each drawn frame; it draws and changes nothing.", {{"dt", "number"}});
  a.event("draw_ui", "Each tick: the place for ui calls.", {});
  input_events(a);
  for (const Row& row : area("node").rows)
    if (row.kind == Row::Kind::event && row.name != "update") a.event(row.name.c_str(), row.doc.c_str(), row.params);
  a.event("on_reload", "After changed files were taken over.", {});
  a.event("on_destroy", "Its node ends, or it is taken off.", {});
}

void fill_task(Area& a) {
  method(a, "stop", "Ends it.", {});
  method(a, "wait", "In a task: goes on when that one has ended.", {});
  method(a, "and_then", "Calls fn(...) when it has ended; returns the task.", {{"fn", "function"}, kRest}, "task");
  property(a, "is_done", "boolean", "Has it ended?");
}

void fill_bot(Area& a) {
  const Param name{"name", "string"};
  a.scripted("press", "Holds a key, button or action down from the next tick on.", {name});
  a.scripted("release", "Lets it go.", {name});
  a.scripted("tap", "Presses it and lets go after some seconds, one tick where none are given.", {name, {"seconds", "number", true}});
  a.scripted("set_axis", "-1 to 1: presses the first name by the negative and the second by the positive part.",
             {{"low", "string"}, {"high", "string"}, {"value", "number"}});
  a.scripted("point_at", "Moves the pointer to a place in ui units, or to a node or point of the world as the camera sees it; point_at(x, y, seconds) takes its time.",
             {{"x", "any"}, {"y", "number", true}, {"seconds", "number", true}});
  a.scripted("turn_wheel", "Turns the wheel by so many steps, away from you.", {{"steps", "number"}});
  a.scripted("type_text", "Types a text, as on_text and fields hear it.", {{"text", "string"}});
  a.scripted("click", "Moves the pointer to the widget with that label or id, presses and lets go. Waits up to a second for it.", {{"label", "string"}});
  a.scripted("is_on_screen", "Is there such a widget, or such a text?", {{"label", "string"}}, "boolean");
  a.scripted("test", "In tests/*.lua: one claim; it runs in a fresh game.", {{"claim", "string"}, {"fn", "function"}});
  a.scripted("expect", "In tests/*.lua: expect(v) and then :equals(x) :near(x, tolerance) :above(x) :below(x) :contains(x), or :raises(text) of a function.",
             {{"value", "any"}}, "expectation");
}

struct Entry {
  const char* name;
  bool object;
  void (*fill)(Area&);
  const char* doc;
};

const Entry kEntries[] = {
    {"globals", false, fill_globals, "Functions that every file sees, beside Lua's own: assert error ipairs pairs next pcall xpcall select tonumber tostring type "
                                     "setmetatable getmetatable rawequal rawget rawlen, and coroutine math string table utf8."},
    {"handlers", false, fill_handlers, "Functions of main.lua that the engine calls by their names. `function on_<message>(...)` answers scene.send."},
    {"math", false, fill_math, "What Lua's math has here in addition. math.random is seeded by the game; there is no randomseed."},
    {"vec3", false, fill_vec3, "vec3(x, y, z): a point or direction. + - * / work by component or with a number, == is exact. Values do not change."},
    {"quat", false, fill_quat, "A rotation. q * r turns by r, then by q; q * v turns a vec3. Values do not change."},
    {"color", false, fill_color, "color(r, g, b, a) with numbers from 0 to 1, or color \"orange\". Wherever a color is taken, a CSS name or \"#rrggbb\" will do."},
    {"behaviour", true, fill_behaviour, "What a behaviour's functions find in self, and the functions that the engine calls."},
    {"task", true, fill_task, "What task.after and its like return, and tween."},
    {"bot", false, fill_bot, "In bot.lua and tests/*.lua only: the same input that a person gives, in effect from the next tick on. bot.lua returns the function that plays."},
};

}  // namespace

const std::deque<Area>& word_areas() {
  static const std::deque<Area> areas = [] {
    std::deque<Area> list;
    for (const Entry& entry : kEntries) {
      Area& area = list.emplace_back();
      area.name = entry.name;
      area.doc = entry.doc;
      area.object = entry.object;
      entry.fill(area);
    }
    return list;
  }();
  return areas;
}

bool is_word_area(const Area& area) {
  for (const Area& word : word_areas())
    if (&word == &area) return true;
  return false;
}

}  // namespace tumble
