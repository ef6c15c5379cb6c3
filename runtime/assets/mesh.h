// Triangle meshes of the built-in shapes, as plain data: what a renderer uploads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/shape.h"

namespace tumble {

struct Vertex {
  std::array<float, 3> position;
  std::array<float, 3> normal;  // unit
  std::array<float, 2> uv{};    // of a texture: 0..1 once over each face, v down
};

// Closed and counter-clockwise seen from outside; axis y, centred on the origin, metres.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> triangles;  // three indices each
};

// A plane is closed too: it is seen from above and from below, and encloses nothing. A shape that is read from a file
// is the stand-in box.
Mesh make_mesh(const Shape& shape);
// The box of the shape's size that shows where something is missing; renderers paint it pink.
bool is_stand_in(const Shape& shape);
// The convex hull; empty for fewer than four points, or points in one plane.
Mesh make_hull(const std::vector<Vec3>& points);
// Equal for shapes that look alike, whatever the fields that their kind does not read.
std::uint64_t mesh_key(const Shape& shape);

}  // namespace tumble
