// The embedding interface of tumble.h over Game.
#include <chrono>
#include <fstream>
#include <utility>

#include "app/runtime_impl.h"
#include "base/text.h"
#include "engine/json.h"

namespace tumble {

namespace {

std::string whole_file(const std::string& file, const char* call) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(call, ": '", file, "' cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void Runtime::Impl::open_window() {
  const Options& o = host.options;
  if (window || !(o.window || o.offscreen)) return;
  const WindowSettings& own = game->settings().window;
  WindowDef def;
  def.title = game->settings().title;
  def.width = o.width > 0 ? o.width : own.width;
  def.height = o.height > 0 ? o.height : own.height;
  def.fullscreen = !o.offscreen && (o.fullscreen || own.fullscreen);
  def.offscreen = o.offscreen;
  def.es = o.gles;
  window = Window::open(def);
  renderer = make_gl_renderer(*window);
}

void Runtime::Impl::open_sound() {
  if (mixer) return mixer->stop_all();  // of the game before
  if (!host.options.sound && !host.options.sound_track) return;
  mixer = std::make_unique<Mixer>();
  if (!host.options.sound_track) audio = Audio::open(*mixer);
}

void Runtime::Impl::open_game(const Stored& kept) {
  game = std::make_unique<Game>(path, host);
  open_sound();
  if (next_recording) game->replay(*next_recording);
  game->open_storage(kept);
  open_window();
  if (window) window->set_title(game->settings().title);
  pending.clear();
  clock = FixedClock(game->tick_seconds(), kMostTicksAFrame);
  first_frame = true;
  game->start();
}

void Runtime::Impl::tick_once() {
  std::vector<InputEvent> events = std::move(pending);
  pending.clear();
  game->screen_shape(aspect(), events);
  game->tick(std::move(events));
  for (const Rumble& rumble : std::exchange(game->script().requests.rumbles, {}))
    if (window) window->rumble(rumble.pad, rumble.strength, rumble.seconds);
  serve_requests();
}

void Runtime::Impl::draw(double alpha, double dt) {
  if (!window) return;
  renderer->draw(game->draw(alpha, dt, aspect()), window->width(), window->height());
  ++frames;
}

void Runtime::Impl::hear() {
  if (!audio) return;
  mixer->update(game->heard());
  audio->poll();
}

// A tick's worth of sound, whatever time it took to compute.
void Runtime::Impl::hear_tick() {
  if (!mixer || audio) return;
  mixer->update(game->heard());
  track_frames += game->tick_seconds() * mixer->rate();
  const auto frames = static_cast<int>(track_frames + 1e-6);
  track_frames -= frames;
  track.resize(track.size() + 2 * static_cast<std::size_t>(frames));
  mixer->mix(track.data() + track.size() - 2 * static_cast<std::size_t>(frames), frames);
}

void Runtime::Impl::handle_keys(const WindowEvents& events) {
  for (const std::string& key : events.keys) {
    if (key == "f3") game->next_debug_view();
    if (key == "f1") go_home();
    if (key == "f5") restart();
    if (key == "f11") window->set_fullscreen(!window->fullscreen());
  }
}

// What concerns the window's input but not the game's.
void Runtime::Impl::serve_input(const WindowEvents& events) {
  for (const std::string& note : events.notes)
    if (host.on_log) host.on_log(LogLevel::note, note);
  Script& script = game->script();
  const ModuleSettings& settings = script.module_settings();
  window->capture_pointer(capture.update(events, settings.pointer_captured, !settings.paused && !script.shown_error));
  window->want_text(script.wants_text());
}

Runtime::Runtime(const Options& options) : impl_(std::make_unique<Impl>()) { impl_->host.options = options; }
Runtime::~Runtime() = default;

void Runtime::add_function(const std::string& name, const std::string& doc, const std::vector<Argument>& arguments,
                           std::function<Data(const std::vector<Data>&)> call) {
  if (impl_->game) fail("add_function: '", name, "' comes after load(); add functions before");
  HostFunction function;
  function.name = name;
  function.doc = doc;
  for (const Argument& argument : arguments) function.params.push_back({argument.name, argument.type, false});
  function.call = [call = std::move(call)](const std::vector<Value>& values) {
    std::vector<Data> data;
    for (const Value& value : values) data.push_back(to_outer(value));
    return to_inner(call(data));
  };
  impl_->host.functions.push_back(std::move(function));
}

void Runtime::on_log(std::function<void(LogLevel, const std::string&)> callback) { impl_->host.on_log = std::move(callback); }
void Runtime::on_script_error(std::function<void(const ScriptError&)> callback) { impl_->host.on_error = std::move(callback); }
void Runtime::on_read_file(std::function<std::optional<std::string>(const std::string&)> callback) { impl_->host.read_file = std::move(callback); }

void Runtime::load(const std::string& path) {
  impl_->path = path;
  impl_->open_game();
}
void Runtime::restart() {
  const Stored kept = impl_->need_game("restart").script().storage.now();
  impl_->open_game(kept);
}

// ---- input

namespace {
InputEvent event_of(InputKind kind, const std::string& name) {
  InputEvent event;
  event.kind = kind;
  event.name = name;
  return event;
}

// An action stands for its first key, so that a host may speak of either.
std::string raw_name(Game& game, const std::string& name, const char* call) {
  const InputMap& input = game.engine().input;
  if (!input.knows(name)) fail(call, ": unknown name '", name, "'", did_you_mean(name, input.known_names()));
  const auto action = input.actions().find(name);
  return action == input.actions().end() || action->second.empty() ? name : action->second.front();
}
}  // namespace

void Runtime::press(const std::string& name) {
  impl_->pending.push_back(event_of(InputKind::press, raw_name(impl_->need_game("press"), name, "press")));
}
void Runtime::press(const std::string& name, Place pointer) {
  move_pointer(pointer);
  press(name);
}
void Runtime::release(const std::string& name) {
  impl_->pending.push_back(event_of(InputKind::release, raw_name(impl_->need_game("release"), name, "release")));
}
void Runtime::set_value(const std::string& name, double value) {
  if (!(value >= 0 && value <= 1)) fail("set_value: 0 to 1 expected, got ", number_text(value));
  InputEvent event = event_of(InputKind::value, raw_name(impl_->need_game("set_value"), name, "set_value"));
  event.value = value;
  impl_->pending.push_back(event);
}
void Runtime::move_pointer(Place place) {
  const InputMap& input = impl_->need_game("move_pointer").engine().input;
  InputEvent event = event_of(InputKind::pointer_move, "");
  event.x = place.x;
  event.y = place.y;
  event.dx = place.x - input.pointer_x;
  event.dy = place.y - input.pointer_y;
  impl_->pending.push_back(event);
}
void Runtime::turn_wheel(double steps) {
  InputEvent event = event_of(InputKind::wheel, "");
  event.value = steps;
  impl_->pending.push_back(event);
}
void Runtime::type_text(const std::string& utf8) {
  if (!is_utf8(utf8)) fail("type_text: the text is not UTF-8");
  impl_->pending.push_back(event_of(InputKind::text, utf8));
}

void Runtime::play_recording(const std::string& file) {
  impl_->next_recording = read_recording(whole_file(file, "play_recording"), file);
  impl_->host.options.seed = impl_->next_recording->seed;
  if (!impl_->path.empty()) impl_->open_game();
}
void Runtime::save_recording(const std::string& file) const {
  std::ofstream out(file, std::ios::binary);
  out << write_recording(impl_->need_game("save_recording").recording());
  if (!out.flush()) fail("save_recording: '", file, "' cannot be written");
}

// ---- time

void Runtime::tick(int count) {
  impl_->need_game("tick");
  for (int i = 0; i < count; ++i) {
    impl_->game->poll_changes();
    impl_->tick_once();
    impl_->hear_tick();
  }
  impl_->hear();
}

bool Runtime::frame() {
  Impl& impl = *impl_;
  impl.need_game("frame");
  if (!impl.window) fail("frame: this runtime has no window; set Options::window, or call tick() and draw()");
  const WindowEvents events = impl.window->poll();
  impl.pending.insert(impl.pending.end(), events.input.begin(), events.input.end());
  impl.handle_keys(events);
  impl.serve_input(events);
  impl.quit |= events.quit;
  impl.game->poll_changes();

  const Clock::time_point now = Clock::now();
  const bool begins = std::exchange(impl.first_frame, false);
  const double real = begins ? 0 : std::chrono::duration<double>(now - impl.last_frame).count();
  impl.last_frame = now;
  const ModuleSettings& settings = impl.game->script().module_settings();
  // A tick at once, lest the first picture, which takes the longest, show a game before its first draw_ui().
  impl.clock.begin_frame(begins ? impl.game->tick_seconds() : real * (settings.paused ? 1 : settings.time_scale));
  impl.game->script().dropped_seconds = impl.clock.dropped_seconds();
  while (!wants_quit() && impl.clock.take_tick()) impl.tick_once();
  // A paused world stands where it is, not between its last two ticks.
  impl.draw(impl.game->script().module_settings().paused ? 1 : impl.clock.part_of_tick(), real);
  impl.hear();
  impl.window->present();
  return !impl.quit && !impl.game->script().requests.quit;
}

void Runtime::draw() {
  impl_->need_game("draw");
  impl_->draw(1, impl_->game->tick_seconds());
}

void Runtime::finish_drawing() {
  if (impl_->renderer) impl_->renderer->finish();
}

void Runtime::save_picture(const std::string& png_file) {
  if (!impl_->renderer) fail("save_picture: nothing is drawn; set Options::offscreen or Options::window");
  write_png(impl_->renderer->picture(), png_file);
}

std::vector<std::uint8_t> Runtime::picture(int& width, int& height) const {
  if (!impl_->renderer) fail("picture: nothing is drawn; set Options::offscreen or Options::window");
  Picture picture = impl_->renderer->picture();
  width = picture.width;
  height = picture.height;
  return std::move(picture.pixels);
}

std::vector<float> Runtime::take_sound() {
  if (!impl_->host.options.sound_track) fail("take_sound: no sound is kept; set Options::sound_track");
  return std::exchange(impl_->track, {});
}

void Runtime::reload() {
  Game& game = impl_->need_game("reload");
  game.reload(game.package().list());
}

// ---- reading

Node Runtime::node(const std::string& path) {
  Node node;
  const NodeId id = impl_->need_game("node").engine().scene.get_by_path(path, {}, "node");
  node.runtime_ = this;
  node.index_ = id.index;
  node.generation_ = id.generation;
  return node;
}

std::optional<Node> Runtime::find(const std::string& path) {
  if (!impl_->need_game("find").engine().scene.find(path)) return std::nullopt;
  return node(path);
}

Data Runtime::report(const std::string& name) const {
  for (const auto& [key, value] : impl_->need_game("report").script().report)
    if (key == name) return to_outer(value);
  return {};
}

std::string Runtime::report_json() const {
  Map game{{"finished", is_finished()}};
  for (const auto& [key, value] : impl_->need_game("report_json").script().report) game.emplace_back(key, value);
  return write_json(game);
}

std::uint64_t Runtime::hash() const { return impl_->need_game("hash").hash(); }
std::int64_t Runtime::tick_number() const { return impl_->game ? impl_->game->ticks() : 0; }
std::int64_t Runtime::frame_number() const { return impl_->frames; }
double Runtime::seconds() const { return impl_->game ? impl_->game->script().seconds_now : 0; }
double Runtime::dropped_seconds() const { return impl_->clock.dropped_seconds(); }
double Runtime::tick_seconds() const { return impl_->game ? impl_->game->tick_seconds() : 1.0 / 60; }
bool Runtime::is_finished() const { return impl_->game && impl_->game->script().finished; }
bool Runtime::wants_quit() const { return impl_->quit || (impl_->game && impl_->game->script().requests.quit); }
bool Runtime::is_loaded() const { return impl_->game && impl_->game->script().loaded(); }
bool Runtime::is_replaying() const { return impl_->game && impl_->game->replaying(); }
bool Runtime::has_file(const std::string& path) const { return impl_->need_game("has_file").package().exists(path); }
int Runtime::script_errors() const { return impl_->game ? impl_->game->errors() : 0; }
std::string Runtime::title() const { return impl_->game ? impl_->game->settings().title : ""; }

void Runtime::send(const std::string& message, const std::vector<Data>& arguments) {
  std::vector<Value> values;
  for (const Data& data : arguments) values.push_back(to_inner(data));
  impl_->need_game("send").script().send(message, values);
}

}  // namespace tumble
