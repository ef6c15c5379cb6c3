// Tumble's embedding interface: load a game, feed it input, tick it, read it. The only installed header.
//
// A host creates one Runtime, loads a game folder or package into it and calls tick(). Nothing runs by itself: no
// thread touches the game, no window opens unless asked for, and time passes only in tick(). All quantities are SI:
// metres, kilograms, seconds, radians; y is up, right-handed, forward is -z. Every function may throw tumble::Error
// and nothing else. A Runtime may be used by one thread at a time; several Runtimes are independent.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#if defined(_WIN32)
#define TUMBLE_API
#else
#define TUMBLE_API __attribute__((visibility("default")))
#endif

namespace tumble {

// An author's or host's mistake, worded for a reader: the call, the value, what was expected, the way out.
class TUMBLE_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

// A point or direction in metres (or whatever the function says).
struct Vec3 {
  double x = 0, y = 0, z = 0;
};

// A unit quaternion: rotation by angle a about the unit axis n is (n sin(a/2), cos(a/2)).
struct Quat {
  double x = 0, y = 0, z = 0, w = 1;
};

// A value that crosses between host and scripts. Numbers are double; nil is the default.
class TUMBLE_API Data {
 public:
  Data() = default;
  Data(bool v) : value_(v) {}
  Data(int v) : value_(static_cast<double>(v)) {}
  Data(double v) : value_(v) {}
  Data(const char* v) : value_(std::string(v)) {}
  Data(std::string v) : value_(std::move(v)) {}
  Data(Vec3 v) : value_(v) {}

  bool is_nil() const { return std::holds_alternative<std::monostate>(value_); }
  double number_or(double other) const { return get(other); }
  bool bool_or(bool other) const { return get(other); }
  std::string string_or(std::string other) const { return get(std::move(other)); }
  Vec3 vec3_or(Vec3 other) const { return get(other); }
  using Content = std::variant<std::monostate, bool, double, std::string, Vec3>;
  const Content& content() const { return value_; }

 private:
  template <class T>
  T get(T other) const {
    const T* v = std::get_if<T>(&value_);
    return v ? *v : other;
  }
  Content value_;
};

enum class LogLevel { print, note, warning, error };

// A failure in a script. The game goes on without the part that failed.
struct ScriptError {
  std::string text;       // "main.lua:7: scene.get: no node 'bal'; did you mean 'ball'?"
  std::string traceback;
  std::string file;       // "" where it has no place
  int line = 0;
  std::string source;     // the text of that line
};

struct Options {
  bool window = false;         // open a window; Error where there is no display
  bool offscreen = false;      // draw pictures without a display
  bool watch = false;          // run the text again at every save (folders only)
  bool bot = false;            // let the game's bot.lua play
  bool sound = false;          // let the game be heard; where there is no device it is silent
  bool sound_track = false;    // keep what would be heard in tick() for take_sound() instead
  std::uint64_t seed = 1;      // of the game's random numbers
  int width = 0, height = 0;   // of the window or picture in pixels; 0 takes the game's own
  bool fullscreen = false;
  bool gles = false;           // draw with OpenGL ES 3.0 rather than OpenGL 3.3
  std::size_t memory_limit = std::size_t{512} << 20;  // bytes that scripts may use
  double time_limit = 1;       // seconds of computing that one call into scripts may take
  // The folder in which games keep what they store, each in a folder of its own; "" keeps nothing beyond this Runtime.
  // With a bot or a recording nothing is read from it or written to it.
  std::string storage;
};

class Runtime;

// A node of the running game. It may outlive the node: is_alive() is then false and all else an Error.
class TUMBLE_API Node {
 public:
  bool is_alive() const;
  std::string name() const;
  Vec3 position() const;        // in the world, m
  Quat rotation() const;        // in the world
  Vec3 velocity() const;        // of its body in the world, m/s; zero without a body
  // A property by path, as scripts write it: "position", "body.mass", "behaviours.ball.scored".
  Data get(const std::string& path) const;
  void set(const std::string& path, const Data& value);

 private:
  friend class Runtime;
  Runtime* runtime_ = nullptr;
  std::uint32_t index_ = 0, generation_ = 0;
};

struct Argument {
  std::string name, type;       // type: "number", "string", "boolean", "vec3" or "any"
};

// One game. See the top of this file for what may be called when.
class TUMBLE_API Runtime {
 public:
  explicit Runtime(const Options& options = {});
  ~Runtime();
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;

  // ---- before load()
  // Adds host.name(...) to Lua. Errors thrown as tumble::Error reach the script as Lua errors.
  void add_function(const std::string& name, const std::string& doc, const std::vector<Argument>& arguments,
                    std::function<Data(const std::vector<Data>&)> call);
  // The same for a callable of numbers, bools, strings and Vec3s: add_function("wind", "...", {"height"}, [](double h) { ... }).
  template <class F>
  void add_function(const std::string& name, const std::string& doc, const std::vector<std::string>& argument_names, F call);
  void on_log(std::function<void(LogLevel, const std::string&)> callback);
  void on_script_error(std::function<void(const ScriptError&)> callback);
  // Gives a file of the game from elsewhere; nothing falls through to the game's own files.
  void on_read_file(std::function<std::optional<std::string>(const std::string& path)> callback);

  // A game folder, a .tumble file, or a program with a game behind it. Throws where there is no game or its game.json is
  // faulty; a faulty script is reported like any script error, and a later save may mend it.
  void load(const std::string& path);
  void restart();

  // ---- input, for the next tick. Raw names ("space", "pointer", "pad_a"); places in ui units (720 high).
  struct Place { double x = 0, y = 0; };
  void press(const std::string& name);
  void press(const std::string& name, Place pointer);
  void release(const std::string& name);
  void set_value(const std::string& name, double value);
  void move_pointer(Place place);
  void turn_wheel(double steps);
  void type_text(const std::string& utf8);
  // Input from a recording takes the place of all other, until it ends.
  void play_recording(const std::string& file);
  void save_recording(const std::string& file) const;

  // ---- time
  void tick(int count = 1);
  // One frame of a window in real time: takes its events, ticks as time demands, draws. False once it should end.
  bool frame();
  // Draws what is now, off screen or into the window; nothing without either.
  void draw();
  // Returns when the picture of the last draw() is finished; drivers otherwise draw while the program goes on. For
  // measuring how long drawing takes.
  void finish_drawing();
  void save_picture(const std::string& png_file);    // of the last draw()
  std::vector<std::uint8_t> picture(int& width, int& height) const;  // RGB, rows from the top
  // What was to be heard in tick() since the last call: left and right in turn, -1 to 1, 48000 of each in a second.
  std::vector<float> take_sound();
  // Runs changed scripts again now; with Options::watch frame() does so by itself, and tick() where it is called.
  void reload();

  // ---- reading
  Node node(const std::string& path);                // Error naming the nearest where there is none
  std::optional<Node> find(const std::string& path);
  Data report(const std::string& name) const;        // game.report.name
  std::string report_json() const;                   // game.report, and "finished"
  std::uint64_t hash() const;                        // of the whole world; equal for equal runs
  std::int64_t tick_number() const;
  std::int64_t frame_number() const;
  double seconds() const;                            // of game time
  double tick_seconds() const;
  // Of game time, that frame() left out since the game was loaded, as the computer was too slow for it; tick() drops none.
  double dropped_seconds() const;
  bool is_finished() const;
  bool wants_quit() const;
  bool is_loaded() const;                            // did the scripts start?
  bool is_replaying() const;                         // is there input of a recording left?
  bool has_file(const std::string& path) const;      // of the game: "bot.lua"
  int script_errors() const;
  std::string title() const;
  void send(const std::string& message, const std::vector<Data>& arguments = {});

  // ---- the game's tests/*.lua: the claims in each; each is run in a Runtime of its own
  std::vector<std::pair<std::string, std::string>> tests();       // file, claim
  // "" where the claim holds, else what was found instead.
  std::string run_test(const std::string& file, const std::string& claim);

 private:
  friend class Node;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// ---- tools of the command line
// The API's documents and editor types, from the table that the bindings come from: path below the folder -> text.
TUMBLE_API std::vector<std::pair<std::string, std::string>> generated_files();
// What is wrong with a game, found without running it: syntax, unknown names, missing files, what nothing reaches.
struct Finding {
  std::string file;       // of the game
  int line = 0;           // 0: the whole file
  std::string text;
  bool is_error = true;   // else it looks wrong and may be meant
};
TUMBLE_API std::vector<Finding> check(const std::string& path);
// The API's names as a configuration for the program luacheck.
TUMBLE_API std::string luacheck_config();
// Packs a game folder into `output`; with a program, behind a copy of it, so that the output runs by itself.
TUMBLE_API void pack(const std::string& folder, const std::string& output, const std::string& program = "");
// Is a game packed behind that program?
TUMBLE_API bool has_packed_game(const std::string& program);
TUMBLE_API bool display_available();
// Where the system wants programs to keep what they store for this person; "" where it names no place.
TUMBLE_API std::string storage_folder();
TUMBLE_API std::string version();

// ---- details of add_function
namespace detail {

template <class T>
struct Cross;
template <>
struct Cross<double> {
  static constexpr const char* name = "number";
  static double from(const Data& d) { return d.number_or(0); }
};
template <>
struct Cross<bool> {
  static constexpr const char* name = "boolean";
  static bool from(const Data& d) { return d.bool_or(false); }
};
template <>
struct Cross<std::string> {
  static constexpr const char* name = "string";
  static std::string from(const Data& d) { return d.string_or(""); }
};
template <>
struct Cross<Vec3> {
  static constexpr const char* name = "vec3";
  static Vec3 from(const Data& d) { return d.vec3_or({}); }
};

template <class F>
struct Signature : Signature<decltype(&F::operator())> {};
template <class C, class R, class... A>
struct Signature<R (C::*)(A...) const> {
  static constexpr std::size_t count = sizeof...(A);
  static std::vector<Argument> arguments(const std::vector<std::string>& names) {
    std::vector<Argument> list{Argument{"", Cross<std::decay_t<A>>::name}...};
    for (std::size_t i = 0; i < list.size() && i < names.size(); ++i) list[i].name = names[i];
    return list;
  }
  template <class F, std::size_t... I>
  static Data call(F& f, const std::vector<Data>& d, std::index_sequence<I...>) {
    (void)d;
    if constexpr (std::is_void_v<R>) {
      f(Cross<std::decay_t<A>>::from(d[I])...);
      return {};
    } else {
      return Data(f(Cross<std::decay_t<A>>::from(d[I])...));
    }
  }
};

}  // namespace detail

template <class F>
void Runtime::add_function(const std::string& name, const std::string& doc, const std::vector<std::string>& argument_names, F call) {
  using S = detail::Signature<F>;
  if (argument_names.size() != S::count)
    throw Error("add_function: '" + name + "' takes " + std::to_string(S::count) + " arguments, and " + std::to_string(argument_names.size()) + " names were given");
  add_function(name, doc, S::arguments(argument_names), std::function<Data(const std::vector<Data>&)>([call](const std::vector<Data>& d) mutable {
                 return S::call(call, d, std::make_index_sequence<S::count>{});
               }));
}

}  // namespace tumble
