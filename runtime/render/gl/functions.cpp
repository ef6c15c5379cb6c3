#include "render/gl/functions.h"

#include "base/error.h"
#include "platform/window.h"

namespace tumble {
namespace {

void* find(const Window& window, const char* name) {
  void* function = window.gl_function(name);
  if (!function) fail("renderer: the graphics driver has no ", name, "; update it");
  return function;
}

}  // namespace

Gl load_gl(const Window& window) {
  Gl gl;
  gl.es = window.is_es();
#define TUMBLE_GL_FIND(Type, name) gl.name = reinterpret_cast<Type>(find(window, "gl" #name));
  TUMBLE_GL_FUNCTIONS(TUMBLE_GL_FIND)
#undef TUMBLE_GL_FIND
  return gl;
}

}  // namespace tumble
