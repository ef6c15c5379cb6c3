#include "render/gl/program.h"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "base/error.h"

namespace tumble {

// Generated from assets/shaders at build time; empty for an unknown name.
std::string_view embedded_shader(std::string_view file);

namespace {

using Files = std::initializer_list<const char*>;

constexpr const char* kDesktopHeader = "#version 330 core\n";
constexpr const char* kEsHeader =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DShadow;\n";

std::string source_of(const Gl& gl, Files files, const std::string& defines) {
  std::string text = (gl.es ? kEsHeader : kDesktopHeader) + defines;
  for (const char* file : files) {
    const std::string_view part = embedded_shader(file);
    assert(!part.empty());
    text += part;
  }
  return text;
}

std::string log_of(const Gl& gl, GLuint object, bool is_program) {
  char text[2048] = "";
  GLsizei length = 0;
  if (is_program) gl.GetProgramInfoLog(object, sizeof text, &length, text);
  else gl.GetShaderInfoLog(object, sizeof text, &length, text);
  return {text, static_cast<std::size_t>(length)};
}

GLuint compile(const Gl& gl, GLenum stage, Files files, const std::string& defines) {
  const GLuint shader = gl.CreateShader(stage);
  const std::string text = source_of(gl, files, defines);
  const char* start = text.c_str();
  gl.ShaderSource(shader, 1, &start, nullptr);
  gl.CompileShader(shader);
  GLint done = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (!done)
    fail("renderer: the graphics driver refuses the shader '", *(files.end() - 1), "': ", log_of(gl, shader, false));
  return shader;
}

}  // namespace

Program::Program(const Gl& gl, Files vertex, Files fragment, const std::string& defines)
    : gl_(gl), program_(gl.CreateProgram()) {
  for (const GLuint shader :
       {compile(gl, GL_VERTEX_SHADER, vertex, defines), compile(gl, GL_FRAGMENT_SHADER, fragment, defines)}) {
    gl.AttachShader(program_, shader);
    gl.DeleteShader(shader);  // lives on while attached
  }
  gl.LinkProgram(program_);
  GLint done = 0;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &done);
  if (!done)
    fail("renderer: the graphics driver cannot link '", *(fragment.end() - 1), "': ", log_of(gl, program_, true));
}

Program::~Program() { gl_.DeleteProgram(program_); }

void Program::use() const { gl_.UseProgram(program_); }

GLint Program::location(const char* name) const {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_[name] = gl_.GetUniformLocation(program_, name);
}

void Program::set(const char* name, int value) const { gl_.Uniform1i(location(name), value); }
void Program::set(const char* name, double value) const { gl_.Uniform1f(location(name), static_cast<float>(value)); }
void Program::set(const char* name, double x, double y) const {
  gl_.Uniform2f(location(name), static_cast<float>(x), static_cast<float>(y));
}
void Program::set(const char* name, Vec3 value) const {
  gl_.Uniform3f(location(name), static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z));
}
void Program::set(const char* name, const std::array<float, 4>& rgb) const {
  gl_.Uniform3f(location(name), rgb[0], rgb[1], rgb[2]);
}
void Program::set(const char* name, const std::vector<std::array<float, 4>>& values) const {
  if (!values.empty()) gl_.Uniform4fv(location(name), static_cast<GLsizei>(values.size()), values[0].data());
}
void Program::set(const char* name, const WideMatrix& value) const {
  Matrix narrow;
  std::transform(value.begin(), value.end(), narrow.begin(), [](double v) { return static_cast<float>(v); });
  gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, narrow.data());
}

}  // namespace tumble
