// A shader program from embedded sources, and its uniforms by name.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "base/math.h"
#include "render/gl/functions.h"
#include "render/view.h"

namespace tumble {

class Program {
 public:
  // Files of assets/shaders, each stage's put one after the other behind `defines`. Throws Error with the driver's
  // words.
  Program(const Gl& gl, std::initializer_list<const char*> vertex, std::initializer_list<const char*> fragment,
          const std::string& defines = "");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  // Of the program in use. A name that the shader does not know, or does not need, is no mistake.
  void set(const char* name, int value) const;
  void set(const char* name, double value) const;
  void set(const char* name, double x, double y) const;
  void set(const char* name, Vec3 value) const;
  void set(const char* name, const std::array<float, 4>& rgb) const;
  void set(const char* name, const std::vector<std::array<float, 4>>& values) const;
  void set(const char* name, const WideMatrix& value) const;

 private:
  GLint location(const char* name) const;

  const Gl& gl_;
  GLuint program_ = 0;
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace tumble
