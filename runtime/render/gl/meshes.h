// Meshes and instances in the graphics card's memory, and the one call that draws them.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/batches.h"
#include "render/gl/functions.h"

namespace tumble {

class GpuMeshes {
 public:
  explicit GpuMeshes(const Gl& gl);
  ~GpuMeshes();
  GpuMeshes(const GpuMeshes&) = delete;
  GpuMeshes& operator=(const GpuMeshes&) = delete;

  // Once for each picture: drops meshes that nobody has drawn for a while.
  void begin_picture();
  // Sends the instances of the draws that follow.
  void upload(const Batches& batches);
  // With the program in use: vertices at locations 0, 1 and 8, instances from 2 on (mesh.vert.glsl).
  void draw(const DrawList& list, const Batch& batch);

 private:
  struct GpuMesh {
    GLuint array = 0, vertices = 0, triangles = 0;
    GLsizei indices = 0;
    std::uint64_t last_drawn = 0;
  };

  const GpuMesh& find(const DrawList& list, const DrawShape& shape, int coarseness);
  void point_at_instances(std::uint32_t first);
  void remove(const GpuMesh& mesh);

  const Gl& gl_;
  GLuint instances_ = 0;
  std::uint64_t picture_ = 0;
  std::unordered_map<std::uint64_t, GpuMesh> meshes_;
};

}  // namespace tumble
