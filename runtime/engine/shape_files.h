// The points that shapes take from files, for physics, which knows no files.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "base/shape.h"

namespace tumble {

// A hull from a file has at most this many corners: more would cost much and change little.
constexpr std::size_t kMostHullCorners = 128;
constexpr std::size_t kMostColliderTriangles = 1'000'000;

// A file without a word about the shape is a mesh.
Shape settled(Shape shape);

class ShapeFiles {
 public:
  // The shape with the points of its file: triangles of a mesh or height field, corners of a hull. A box of its size
  // where the file is missing or broken, or there is no library. Throws Error for too many triangles.
  Shape with_points(const Shape& shape, AssetLibrary* assets);

 private:
  struct Kept {
    std::uint64_t version = 0;
    std::vector<Vec3> points;
  };
  std::map<std::pair<std::string, bool>, Kept> kept_;  // by file; as a hull or not
};

}  // namespace tumble
