#include "render/gl/stream.h"

#include <cstdint>

namespace tumble {

Stream::Stream(const Gl& gl, std::initializer_list<int> floats, int divisor) : gl_(gl) {
  gl_.GenVertexArrays(1, &array_);
  gl_.GenBuffers(1, &buffer_);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  int all = 0;
  for (const int count : floats) all += count;
  GLuint location = 0;
  std::uintptr_t offset = 0;
  for (const int count : floats) {
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, all * static_cast<int>(sizeof(float)),
                            reinterpret_cast<const void*>(offset));
    gl_.VertexAttribDivisor(location, static_cast<GLuint>(divisor));
    ++location;
    offset += count * sizeof(float);
  }
  gl_.BindVertexArray(0);
}

Stream::~Stream() {
  gl_.DeleteBuffers(1, &buffer_);
  gl_.DeleteVertexArrays(1, &array_);
}

void Stream::use(const void* data, std::size_t bytes) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

}  // namespace tumble
