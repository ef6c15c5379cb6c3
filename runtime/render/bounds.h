// How far meshes reach, to leave out of a picture what cannot be seen. No GL here.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "assets/mesh.h"
#include "render/draw_list.h"

namespace tumble {

// The triangles of one of the list's shapes; the stand-in box where the file or the part is missing.
Mesh mesh_of(const DrawList& list, const DrawShape& shape, int coarseness = 0);
// Equal for equal triangles, also after a file was saved anew.
std::uint64_t geometry_key(const DrawList& list, const DrawShape& shape, int coarseness = 0);

// A box around a mesh, in the mesh's own space.
struct MeshBox {
  Vec3 middle, half;
};
// A ball around a mesh, in picture space.
struct Ball {
  float x = 0, y = 0, z = 0, radius = 0;
};

// Boxes of shapes, kept from picture to picture.
class MeshBoxes {
 public:
  // One for each of the list's shapes, in their order.
  const std::vector<MeshBox>& find(const DrawList& list);

 private:
  std::unordered_map<std::uint64_t, MeshBox> known_;
  std::vector<MeshBox> found_;
};

// One for each of the list's meshes, in their order.
std::vector<Ball> balls(const DrawList& list, const std::vector<MeshBox>& boxes);

// What the camera can see.
class Frustum {
 public:
  Frustum(const DrawList& list, double aspect);
  bool may_see(const Ball& ball) const;
  // May it see a shadow that the ball throws along the light (unit) onto something at most `reach` away?
  bool may_see_shadow(const Ball& ball, const std::array<float, 3>& light, float reach) const;

 private:
  std::array<float, 3> forward_, right_, up_;  // unit
  float near_, far_, across_, upward_;         // tangents of half the openings
  float across_slant_, upward_slant_;          // how much farther a ball reaches toward the slanted sides
};

}  // namespace tumble
