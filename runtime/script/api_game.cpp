// The game, its clock, chance and log; and the modules that scripts/boot provides.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "engine/ui/ui.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

// ---- time
double now(Script& s) { return s.phase() == Phase::declare ? 0 : s.seconds_now; }
std::int64_t tick(Script& s) { return s.phase() == Phase::declare ? 0 : static_cast<std::int64_t>(s.engine().tick); }
double tick_seconds(Script& s) { return 1 / s.engine().settings.tick_rate; }
double dropped_seconds(Script& s) { return s.phase() == Phase::declare ? 0 : s.dropped_seconds; }
double scale(Script& s) { return s.settings().time_scale; }
void set_scale(Script& s, double v) {
  if (v < 0.01 || v > 100) fail("time.scale: 0.01 to 100 expected, got ", number_text(v), "; time.paused = true stops time");
  s.settings().time_scale = v;
}
bool paused(Script& s) { return s.settings().paused; }
void set_paused(Script& s, bool on) { s.settings().paused = on; }
void step(Script& s) { ++s.steps_wanted; }

// ---- random
double number_between(Script& s, double a, double b) { return a + (b - a) * s.random().unit(); }
bool chance(Script& s, double p) { return s.random().unit() < p; }
Vec3 direction(Script& s) {
  // Archimedes: the height of a point on a sphere is evenly spread.
  const double z = 2 * s.random().unit() - 1, turn = 2 * kPi * s.random().unit(), r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), z, r * std::sin(turn)};
}
Vec3 in_sphere(Script& s, double radius) {
  const double r = radius * std::cbrt(s.random().unit());
  return direction(s) * r;
}
int choice(lua_State* L) {
  return at_border(L, [L] {
    if (!lua_istable(L, 1) || lua_rawlen(L, 1) == 0) fail("random.choice: a list with at least one entry expected, got ", describe_argument(L, 1));
    return lua_rawgeti(L, 1, script_of(L).random().between(1, static_cast<std::int64_t>(lua_rawlen(L, 1)))), 1;
  });
}
int shuffle(lua_State* L) {
  return at_border(L, [L] {
    if (!lua_istable(L, 1)) fail("random.shuffle: a list expected, got ", describe_argument(L, 1));
    for (auto i = static_cast<lua_Integer>(lua_rawlen(L, 1)); i > 1; --i) {
      const lua_Integer k = script_of(L).random().between(1, i);
      lua_rawgeti(L, 1, i);
      lua_rawgeti(L, 1, k);
      lua_rawseti(L, 1, i);
      lua_rawseti(L, 1, k);
    }
    return lua_settop(L, 1), 1;
  });
}

// ---- log
void warn(Script& s, std::string text) { s.log(LogLevel::warning, text); }
void error(Script& s, std::string text) { s.log(LogLevel::error, text); }
void watch(Script& s, std::string name, Anything value) {
  lua_State* L = s.stack();
  std::string text = luaL_tolstring(L, value.index, nullptr);
  if (lua_type(L, value.index) == LUA_TNUMBER && !lua_isinteger(L, value.index)) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.3f", lua_tonumber(L, value.index));
    text = buffer;
  }
  lua_pop(L, 1);
  for (auto& [known, old] : s.drawing().watches)
    if (known == name) {
      old = text;
      return;
    }
  s.drawing().watches.emplace_back(name, text);
}

// ---- game
std::string title(Script& s) { return s.engine().settings.title; }
void finish(Script& s) {
  s.finished = true;
  s.requests.finish = true;
}
bool is_finished(Script& s) { return s.finished; }
void restart(Script& s) { s.requests.restart = true; }
void quit(Script& s) { s.requests.quit = true; }
std::int64_t seed(Script& s) { return static_cast<std::int64_t>(s.seed()); }
Results report(Script& s) {
  lua_rawgetp(s.stack(), LUA_REGISTRYINDEX, &s.report);
  return {1};
}

}  // namespace

void rows_time(Area& a) {
  a.prop<now>("now", "Game seconds since the start; it stands while paused.");
  a.prop<tick>("tick", "Ticks since the start.");
  a.prop<tick_seconds>("tick_seconds", "The length of a tick, s.");
  a.prop<dropped_seconds>("dropped_seconds", "Game seconds left out since the start, as the computer was too slow for them: a frame makes up for 6 ticks at most. To be shown, not to be played by: it differs from run to run, and is 0 in bots' runs, tests and replays without a window.");
  a.prop<scale, set_scale>("scale", "1 is normal, 0.5 half as fast: fewer ticks a second, each as long as ever. 0.01 to 100; menus of a paused game run as ever.");
  a.prop<paused, set_paused>("paused", "Stops updates, physics and tasks; input handlers of main.lua and draw_ui go on.");
  a.fn<step>("step", "One tick while paused.").acts();
}

void rows_random(Area& a) {
  a.fn<number_between>("between", "A number from a to b.", "a", "b");
  a.raw("choice", "One entry of a list.", choice, {{"list", "list", false}}, "any");
  a.fn<chance>("chance", "True with probability p.", "p");
  a.raw("shuffle", "Mixes a list in place and returns it.", shuffle, {{"list", "list", false}}, "list");
  a.fn<direction>("direction", "A direction, all equally likely; length 1.");
  a.fn<in_sphere>("in_sphere", "A point in a sphere around zero, all equally likely.", "radius");
}

void rows_log(Area& a) {
  a.fn<warn>("warn", "A line that warns.", "text");
  a.fn<error>("error", "A line that tells of an error; the script goes on.", "text");
  a.fn<watch>("watch", "A live line on the screen.", "name", "value");
}

void rows_game(Area& a) {
  a.prop<title>("title", "From game.json.");
  a.prop<seed>("seed", "The seed of its random numbers.");
  a.prop<report>("report", "What the game tells of itself: game.report.score = 3 goes into --report.").gives("table");
  a.prop<is_finished>("is_finished", "Was game.finish() called?");
  a.fn<finish>("finish", "The game has come to its end; headless runs stop.").acts();
  a.fn<restart>("restart", "Starts everything anew, as F5 does.").acts();
  a.fn<quit>("quit", "Leaves.").acts();
  rows_games(a);
}

void rows_task(Area& a) {
  a.scripted("after", "Calls fn(...) after some seconds.", {{"seconds", "number"}, {"fn", "function"}, {"...", "any", true}}, "task").acts();
  a.scripted("every", "Calls fn(...) again and again, that many seconds apart.", {{"seconds", "number"}, {"fn", "function"}, {"...", "any", true}}, "task").acts();
  a.scripted("spawn", "Runs fn(...) as a task, in which wait() and wait_until() work.", {{"fn", "function"}, {"...", "any", true}}, "task").acts();
  a.scripted("loop", "Runs fn(...) as a task again and again; it must wait somewhere.", {{"fn", "function"}, {"...", "any", true}}, "task").acts();
}

void rows_property_module(Area& a) {
  a.scripted("number", "A number with bounds: property.number { 6, min = 0, max = 20 }.", {{"options", "table"}}, "property");
  a.scripted("choice", "One of some words, the first by default: property.choice { \"calm\", \"angry\" }.", {{"words", "list of string"}}, "property");
  a.scripted("node", "A node; in files a path from the file's root.", {}, "property");
  a.scripted("asset", "The path of a file.", {{"kind", "string"}}, "property");
}

void rows_property(Area&) {}

}  // namespace tumble
