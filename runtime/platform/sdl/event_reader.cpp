#include "platform/sdl/event_reader.h"

#include <string>

#include "platform/sdl/keys.h"

namespace tumble {
namespace {

constexpr double kUiHeight = 720;

bool is_function_key(SDL_Scancode key) { return key >= SDL_SCANCODE_F1 && key <= SDL_SCANCODE_F12; }
bool is_ours(SDL_Scancode key) { return key == SDL_SCANCODE_F3 || key == SDL_SCANCODE_F5 || key == SDL_SCANCODE_F11; }

InputEvent wheel(const SDL_MouseWheelEvent& event) {
  InputEvent result;
  result.kind = InputKind::wheel;
  result.value = static_cast<double>(event.preciseY);
  if (event.direction == SDL_MOUSEWHEEL_FLIPPED) result.value = -result.value;
  return result;
}

InputEvent typed(const char* text) {
  InputEvent result;
  result.kind = InputKind::text;
  result.name = text;
  return result;
}

}  // namespace

void EventReader::read(const SDL_Event& event, int window_height, WindowEvents& out) {
  const double to_ui = kUiHeight / (window_height > 0 ? window_height : 1);
  switch (event.type) {
    case SDL_QUIT: out.quit = true; break;
    case SDL_WINDOWEVENT: window(event.window, out); break;
    case SDL_KEYDOWN:
    case SDL_KEYUP: key(event.key, out); break;
    case SDL_TEXTINPUT: out.input.push_back(typed(event.text.text)); break;
    case SDL_MOUSEMOTION: motion(event.motion, to_ui, out); break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: button(event.button, to_ui, out); break;
    case SDL_MOUSEWHEEL:
      if (event.wheel.preciseY != 0) out.input.push_back(wheel(event.wheel));
      break;
    default: pads_.handle(event, held_, out); break;
  }
}

void EventReader::key(const SDL_KeyboardEvent& event, WindowEvents& out) {
  const SDL_Scancode code = event.keysym.scancode;
  const char* name = key_name(code);
  if (!name || event.repeat) return;
  const bool down = event.state == SDL_PRESSED;
  if (down && is_function_key(code)) out.keys.push_back(name);
  if (is_ours(code)) return;
  if (down) held_.press(name, out.input);
  else held_.release(name, out.input);
}

void EventReader::button(const SDL_MouseButtonEvent& event, double to_ui, WindowEvents& out) {
  const char* name = pointer_name(event.button);
  if (!name) return;
  // A finger or a pen lands where no motion led to.
  const double x = event.x * to_ui, y = event.y * to_ui;
  if (!SDL_GetRelativeMouseMode() && (x != x_ || y != y_)) pointer_to(x, y, x - x_, y - y_, out);
  if (event.state == SDL_PRESSED) held_.press(name, out.input);
  else held_.release(name, out.input);
}

void EventReader::motion(const SDL_MouseMotionEvent& event, double to_ui, WindowEvents& out) {
  const bool captured = SDL_GetRelativeMouseMode();
  pointer_to(captured ? x_ : event.x * to_ui, captured ? y_ : event.y * to_ui, event.xrel * to_ui, event.yrel * to_ui,
             out);
}

void EventReader::pointer_to(double x, double y, double dx, double dy, WindowEvents& out) {
  InputEvent result;
  result.kind = InputKind::pointer_move;
  result.x = x_ = x;
  result.y = y_ = y;
  result.dx = dx;
  result.dy = dy;
  out.input.push_back(result);
}

void EventReader::window(const SDL_WindowEvent& event, WindowEvents& out) {
  if (event.event == SDL_WINDOWEVENT_CLOSE) out.quit = true;
  if (event.event == SDL_WINDOWEVENT_FOCUS_GAINED) out.focus_gained = true;
  if (event.event == SDL_WINDOWEVENT_FOCUS_LOST) {
    out.focus_lost = true;
    held_.release_all(out.input);
    pads_.forget();
  }
}

}  // namespace tumble
