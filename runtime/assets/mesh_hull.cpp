// The convex hull of a handful of points, one point after the other: a point outside removes the faces that it sees
// and is joined to the rim of the hole. Quadratic in the number of points, which for a student's shape is nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "assets/mesh.h"

namespace tumble {
namespace {

struct Face {
  int a, b, c;
  Vec3 normal;  // unit, outward
};

Face make_face(const std::vector<Vec3>& p, int a, int b, int c) {
  return {a, b, c, normalized(cross(p[b] - p[a], p[c] - p[a]))};
}

// Indices of four points that span a volume, counter-clockwise seen from outside the first three; empty if none do.
std::vector<int> first_tetrahedron(const std::vector<Vec3>& p, double tolerance) {
  const auto farthest = [&](auto measure) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(p.size()); ++i)
      if (measure(p[i]) > measure(p[best])) best = i;
    return best;
  };
  const int a = farthest([](Vec3 v) { return v.x; });
  const int b = farthest([&](Vec3 v) { return distance(v, p[a]); });
  const Vec3 along = normalized(p[b] - p[a]);
  const int c = farthest([&](Vec3 v) { return length(cross(v - p[a], along)); });
  const Vec3 normal = normalized(cross(p[b] - p[a], p[c] - p[a]));
  const int d = farthest([&](Vec3 v) { return std::abs(dot(v - p[a], normal)); });
  const double height = dot(p[d] - p[a], normal);
  if (length(normal) == 0 || std::abs(height) <= tolerance) return {};
  return height < 0 ? std::vector<int>{a, b, c, d} : std::vector<int>{a, c, b, d};
}

void add_point(std::vector<Face>& faces, const std::vector<Vec3>& p, int point, double tolerance) {
  std::set<std::pair<int, int>> rim;  // edges of removed faces whose neighbour stays
  std::vector<Face> kept;
  for (const Face& face : faces) {
    if (dot(p[point] - p[face.a], face.normal) <= tolerance) {
      kept.push_back(face);
      continue;
    }
    for (const auto& [from, to] : {std::pair{face.a, face.b}, {face.b, face.c}, {face.c, face.a}}) {
      const auto twin = rim.find({to, from});
      if (twin != rim.end()) rim.erase(twin);
      else rim.insert({from, to});
    }
  }
  for (const auto& [from, to] : rim) kept.push_back(make_face(p, from, to, point));
  faces = std::move(kept);
}

// Laid on from the side that a face turns to most, once over the whole hull.
std::array<float, 2> laid_on(Vec3 place, Vec3 normal, Vec3 low, Vec3 high) {
  const Vec3 size = high - low;
  const auto share = [](double from, double whole) { return static_cast<float>(whole > 0 ? from / whole : 0.5); };
  const float x = share(place.x - low.x, size.x), y = share(place.y - low.y, size.y), z = share(place.z - low.z, size.z);
  const Vec3 side{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  if (side.y >= std::max(side.x, side.z)) return {x, normal.y > 0 ? z : 1 - z};
  if (side.z >= side.x) return {normal.z > 0 ? x : 1 - x, 1 - y};
  return {normal.x > 0 ? 1 - z : z, 1 - y};
}

Mesh flat_shaded(const std::vector<Face>& faces, const std::vector<Vec3>& p) {
  Mesh mesh;
  Vec3 low = p[0], high = p[0];
  for (const Vec3 v : p) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  for (const Face& face : faces)
    for (const int corner : {face.a, face.b, face.c}) {
      const auto f = [](double value) { return static_cast<float>(value); };
      const Vec3 v = p[corner], n = face.normal;
      mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({{f(v.x), f(v.y), f(v.z)}, {f(n.x), f(n.y), f(n.z)}, laid_on(v, n, low, high)});
    }
  return mesh;
}

}  // namespace

Mesh make_hull(const std::vector<Vec3>& points) {
  if (points.size() < 4) return {};
  double size = 0;
  for (const Vec3 point : points) size = std::max(size, distance(point, points[0]));
  const double tolerance = 1e-9 * size;

  const std::vector<int> t = first_tetrahedron(points, tolerance);
  if (t.empty()) return {};
  std::vector<Face> faces = {make_face(points, t[0], t[1], t[2]), make_face(points, t[0], t[3], t[1]),
                             make_face(points, t[1], t[3], t[2]), make_face(points, t[2], t[3], t[0])};
  for (int i = 0; i < static_cast<int>(points.size()); ++i) add_point(faces, points, i, tolerance);
  return flat_shaded(faces, points);
}

}  // namespace tumble
