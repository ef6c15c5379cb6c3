// The inside of Runtime, for the sources that implement tumble.h.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/game.h"
#include "app/pointer_capture.h"
#include "base/fixed_clock.h"
#include "platform/audio.h"
#include "platform/mixer.h"
#include "platform/window.h"
#include "render/renderer.h"

namespace tumble {

using Clock = std::chrono::steady_clock;

// How many ticks a frame may catch up before time is dropped: a tenth of a second at 60 Hz.
constexpr int kMostTicksAFrame = 6;

struct __attribute__((visibility("hidden"))) Runtime::Impl {
  GameHost host;
  std::string path;
  std::string home;             // the game that opened this one and comes back after it; "": none did
  std::unique_ptr<Window> window;
  std::unique_ptr<Renderer> renderer;
  std::unique_ptr<Game> game;
  std::unique_ptr<Mixer> mixer;    // null: nothing is heard
  std::unique_ptr<Audio> audio;    // null: what is mixed goes to the sound track
  std::vector<float> track;
  double track_frames = 0;         // that are still to be mixed: a tick need not last a whole number of them
  std::vector<InputEvent> pending;
  std::int64_t frames = 0;
  Clock::time_point last_frame;
  bool first_frame = true, quit = false;
  PointerCapture capture;
  FixedClock clock{1.0 / 60, kMostTicksAFrame};  // of the game; made anew with it
  std::optional<Recording> next_recording;

  Game& need_game(const char* call) {
    if (!game) fail(call, ": no game is loaded; call load() first");
    return *game;
  }
  double aspect() const { return window ? static_cast<double>(window->width()) / window->height() : 16.0 / 9.0; }
  void open_window();
  void open_game(const Stored& kept = {});   // kept: what it stored before a restart
  void open_sound();
  // runtime_games.cpp
  void serve_requests();
  void restart();
  void open_other(const std::string& other);
  void go_home();
  bool reopen(const std::string& wanted, const Stored& kept, const std::string& note);

  void tick_once();
  void draw(double alpha, double dt);
  void hear();
  void hear_tick();
  void handle_keys(const WindowEvents& events);
  void serve_input(const WindowEvents& events);
};

Value to_inner(const Data& data);
Data to_outer(const Value& value);

}  // namespace tumble
