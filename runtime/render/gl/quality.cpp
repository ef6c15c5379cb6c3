#include "render/gl/quality.h"

#include <algorithm>
#include <string>

namespace tumble {
namespace {

bool is_software(const Gl& gl) {
  const std::string name = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "SWR"})
    if (name.find(software) != std::string::npos) return true;
  return false;
}

}  // namespace

Quality quality_for(const Gl& gl, DrawQuality wanted) {
  if (wanted == DrawQuality::software || (wanted == DrawQuality::by_driver && is_software(gl))) return {0, 1024, 2, 8};
  Quality quality;
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most);
  quality.edge_samples = std::min(quality.edge_samples, static_cast<int>(most));
  return quality;
}

}  // namespace tumble
