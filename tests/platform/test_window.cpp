// Off screen, with events put into SDL's queue as a keyboard or mouse would.
#include "platform/window.h"

#include <SDL2/SDL.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/error.h"

using namespace tumble;

namespace {

std::unique_ptr<Window> open_hidden() {
  WindowDef def;
  def.width = 640;
  def.height = 360;
  def.offscreen = true;
  auto window = Window::open(def);
  window->poll();  // what opening itself brings
  return window;
}

void push_key(SDL_Scancode key, bool down, bool repeat = false) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.key.repeat = repeat;
  event.key.keysym.scancode = key;
  SDL_PushEvent(&event);
}

void push_button(int button, bool down, int x, int y) {
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = static_cast<Uint8>(button);
  event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.button.x = x;
  event.button.y = y;
  SDL_PushEvent(&event);
}

void push_window(SDL_WindowEventID id) {
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = static_cast<Uint8>(id);
  SDL_PushEvent(&event);
}

}  // namespace

TEST_CASE("window: keys go by place, and holding one is one press", "[platform]") {
  const auto window = open_hidden();
  push_key(SDL_SCANCODE_W, true);
  push_key(SDL_SCANCODE_W, true, true);
  push_key(SDL_SCANCODE_W, false);

  const WindowEvents events = window->poll();

  REQUIRE(events.input.size() == 2);
  CHECK(events.input[0].kind == InputKind::press);
  CHECK(events.input[0].name == "w");
  CHECK(events.input[1].kind == InputKind::release);
}

TEST_CASE("window: every key that SDL can press has a raw name of ours or none", "[platform]") {
  const auto window = open_hidden();
  int named = 0;
  for (int code = 0; code < SDL_NUM_SCANCODES; ++code) {
    push_key(static_cast<SDL_Scancode>(code), true);
    for (const InputEvent& event : window->poll().input) {
      INFO(event.name);
      CHECK(is_raw_input_name(event.name));
      ++named;
    }
  }
  CHECK(named > 90);
}

TEST_CASE("window: f3, f5 and f11 are ours, other function keys the game's as well", "[platform]") {
  const auto window = open_hidden();
  for (const SDL_Scancode key : {SDL_SCANCODE_F3, SDL_SCANCODE_F5, SDL_SCANCODE_F11, SDL_SCANCODE_F1})
    push_key(key, true);

  const WindowEvents events = window->poll();

  CHECK(events.keys == std::vector<std::string>{"f3", "f5", "f11", "f1"});
  REQUIRE(events.input.size() == 1);
  CHECK(events.input[0].name == "f1");
}

TEST_CASE("window: the pointer is in ui units, and a click says first where it is", "[platform]") {
  const auto window = open_hidden();
  push_button(SDL_BUTTON_LEFT, true, 320, 90);

  const WindowEvents events = window->poll();

  REQUIRE(events.input.size() == 2);
  CHECK(events.input[0].kind == InputKind::pointer_move);
  CHECK(events.input[0].x == Approx(640));
  CHECK(events.input[0].y == Approx(180));
  CHECK(events.input[1].name == "pointer");
}

TEST_CASE("window: losing focus releases what is held", "[platform]") {
  const auto window = open_hidden();
  push_key(SDL_SCANCODE_W, true);
  push_button(SDL_BUTTON_RIGHT, true, 0, 0);
  window->poll();
  push_window(SDL_WINDOWEVENT_FOCUS_LOST);
  push_key(SDL_SCANCODE_W, false);

  const WindowEvents events = window->poll();

  CHECK(events.focus_lost);
  REQUIRE(events.input.size() == 2);
  CHECK(events.input[0].name == "pointer_right");
  CHECK(events.input[1].name == "w");
  CHECK(events.input[1].kind == InputKind::release);
}

TEST_CASE("window: wheel, typed text and quit", "[platform]") {
  const auto window = open_hidden();
  SDL_Event event{};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.preciseY = 2;
  event.wheel.direction = SDL_MOUSEWHEEL_FLIPPED;
  SDL_PushEvent(&event);
  event = {};
  event.type = SDL_TEXTINPUT;
  std::strcpy(event.text.text, "ß");
  SDL_PushEvent(&event);
  push_window(SDL_WINDOWEVENT_CLOSE);

  const WindowEvents events = window->poll();

  REQUIRE(events.input.size() == 2);
  CHECK(events.input[0].value == -2);
  CHECK(events.input[1].kind == InputKind::text);
  CHECK(events.input[1].name == "ß");
  CHECK(events.quit);
}

TEST_CASE("window: the input method is on only while text is wanted", "[platform]") {
  const auto window = open_hidden();
  CHECK_FALSE(SDL_IsTextInputActive());
  window->want_text(true);
  CHECK(SDL_IsTextInputActive());
  window->want_text(false);
  CHECK_FALSE(SDL_IsTextInputActive());
}

TEST_CASE("window: drawing off screen leaves environment and signals alone", "[platform]") {
  const std::string before = std::getenv("SDL_VIDEODRIVER") ? std::getenv("SDL_VIDEODRIVER") : "";
  struct sigaction at_first {}, now {};
  sigaction(SIGINT, nullptr, &at_first);

  const auto window = open_hidden();
  sigaction(SIGINT, nullptr, &now);

  CHECK((std::getenv("SDL_VIDEODRIVER") ? std::getenv("SDL_VIDEODRIVER") : "") == before);
  CHECK(now.sa_handler == at_first.sa_handler);
}

TEST_CASE("window: an impossible size is refused with the sizes that are possible", "[platform]") {
  WindowDef def;
  def.width = 0;
  def.offscreen = true;

  CHECK_THROWS_WITH(Window::open(def), Catch::Contains("cannot be 0 x 720") && Catch::Contains("16 to 16384"));
}

TEST_CASE("window: no display means a sentence that names the way out", "[platform]") {
  if (Window::display_available()) return;  // a person's desk: nothing to show
  CHECK_THROWS_WITH(Window::open(WindowDef{}), Catch::Contains("off screen"));
}
