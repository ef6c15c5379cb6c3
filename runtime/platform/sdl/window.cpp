#include "platform/window.h"

#include <SDL.h>

#include "base/error.h"
#include "platform/sdl/event_reader.h"
#include "platform/sdl/video.h"

namespace tumble {
namespace {

constexpr int kSmallestSide = 16;

void ask_for_context(bool es) {
  SDL_GL_ResetAttributes();
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, es ? SDL_GL_CONTEXT_PROFILE_ES : SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, es ? 0 : 3);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);  // the renderer draws into its own buffers
}

Uint32 window_flags(const WindowDef& def) {
  Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
  if (def.offscreen) flags |= SDL_WINDOW_HIDDEN;
  else if (def.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
  return flags;
}

class SdlWindow final : public Window {
 public:
  explicit SdlWindow(const WindowDef& def) : video_(def.offscreen) {
    const std::string core = def.es ? "not asked for" : try_open(def, false);
    const std::string es = context_ ? "" : try_open(def, true);
    if (!context_)
      fail("window: no usable OpenGL; OpenGL 3.3 core: ", core, "; OpenGL ES 3.0: ", es,
           "; install or update the graphics driver (Mesa's libgl1-mesa-dri draws without a graphics card)");
    SDL_SetWindowMinimumSize(window_, kSmallestSide, kSmallestSide);
    SDL_GL_SetSwapInterval(def.vsync && !def.offscreen ? 1 : 0);
    SDL_StopTextInput();  // SDL begins with it on, and an input method would take keys that are meant for the game
    if (!def.offscreen) reader_.start_pads();
  }

  ~SdlWindow() override { close(); }

  WindowEvents poll() override {
    WindowEvents result;
    int width = 0, height = 0;
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
      SDL_GetWindowSize(window_, &width, &height);
      reader_.read(event, height, result);
    }
    return result;
  }

  int width() const override { return drawable().width; }
  int height() const override { return drawable().height; }
  bool is_es() const override { return es_; }
  void present() override { SDL_GL_SwapWindow(window_); }

  void set_fullscreen(bool on) override { SDL_SetWindowFullscreen(window_, on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0); }
  bool fullscreen() const override { return (SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN) != 0; }
  void set_size(int width, int height) override { SDL_SetWindowSize(window_, width, height); }
  void set_title(const std::string& title) override { SDL_SetWindowTitle(window_, title.c_str()); }
  void capture_pointer(bool on) override { SDL_SetRelativeMouseMode(on ? SDL_TRUE : SDL_FALSE); }
  void want_text(bool on) override {
    if (on == static_cast<bool>(SDL_IsTextInputActive())) return;
    on ? SDL_StartTextInput() : SDL_StopTextInput();
  }
  void rumble(int pad, double strength, double seconds) override { reader_.rumble(pad, strength, seconds); }
  void make_current() override { SDL_GL_MakeCurrent(window_, context_); }
  void* gl_function(const char* name) const override { return SDL_GL_GetProcAddress(name); }

 private:
  struct Size {
    int width = 0, height = 0;
  };

  Size drawable() const {
    Size size;
    SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
    return size;
  }

  // What went wrong, or "" when there is a window with a context.
  std::string try_open(const WindowDef& def, bool es) {
    ask_for_context(es);
    es_ = es;
    window_ = SDL_CreateWindow(def.title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, def.width,
                               def.height, window_flags(def));
    if (window_) context_ = SDL_GL_CreateContext(window_);
    if (context_) return "";
    const std::string reason = SDL_GetError();
    close();
    return reason.empty() ? "refused without a reason" : reason;
  }

  void close() {
    if (context_) SDL_GL_DeleteContext(context_);
    if (window_) SDL_DestroyWindow(window_);
    context_ = nullptr;
    window_ = nullptr;
  }

  Video video_;
  SDL_Window* window_ = nullptr;
  SDL_GLContext context_ = nullptr;
  bool es_ = false;
  EventReader reader_;
};

}  // namespace

std::unique_ptr<Window> Window::open(const WindowDef& def) {
  if (def.width < kSmallestSide || def.height < kSmallestSide || def.width > 16384 || def.height > 16384)
    fail("window: cannot be ", def.width, " x ", def.height, " pixels; give each side ", kSmallestSide, " to 16384");
  return std::make_unique<SdlWindow>(def);
}

}  // namespace tumble
