#include "physics/pairs/polyhedron.h"

#include <algorithm>
#include <map>
#include <set>

namespace tumble::pairs {

namespace {

// Of its size: nearer than this, points are one point and triangles lie in one plane.
constexpr double kSame = 1e-6;
// Of its size: hulls are found on a grid, and an edge that is concave by less is a flat one.
constexpr double kConcave = 2e-4;

using Loop = std::vector<int>;

double size_of(const std::vector<Triangle>& hull) {
  double size = 0;
  for (const Triangle& t : hull)
    for (const Vec3 p : {t.a, t.b, t.c}) size = std::max(size, distance(p, hull[0].a));
  return size;
}

int vertex_at(Polyhedron& made, Vec3 point, double near) {
  for (std::size_t i = 0; i < made.vertices.size(); ++i)
    if (distance(made.vertices[i], point) <= near) return static_cast<int>(i);
  made.vertices.push_back(point);
  return static_cast<int>(made.vertices.size()) - 1;
}

Vec3 area_normal(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a); }

// As thin as nothing: it lies along an edge of its neighbours, and its normal is any.
bool is_sliver(const Triangle& t, double near) {
  const double longest = std::max({distance(t.a, t.b), distance(t.b, t.c), distance(t.c, t.a)});
  return length(area_normal(t.a, t.b, t.c)) <= near * longest;
}

// The way round the triangles of one plane: of each edge that two of them share, neither direction is on it.
Loop outline(const std::vector<Loop>& triangles) {
  std::set<std::pair<int, int>> edges;
  for (const Loop& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = t[i], to = t[(i + 1) % 3];
      if (!edges.erase({to, from})) edges.insert({from, to});
    }
  const std::map<int, int> next(edges.begin(), edges.end());
  Loop loop;
  if (next.empty()) return loop;
  int at = next.begin()->first;
  do {
    loop.push_back(at);
    const auto step = next.find(at);
    if (step == next.end()) return {};
    at = step->second;
  } while (at != loop[0] && loop.size() < next.size());
  return loop;
}

void drop_straight_corners(const std::vector<Vec3>& vertices, Loop& loop, double near) {
  for (std::size_t i = 0; i < loop.size() && loop.size() > 3;) {
    const auto at = [&](std::size_t k) { return vertices[static_cast<std::size_t>(loop[k % loop.size()])]; };
    const Vec3 before = at(i + loop.size() - 1), along = at(i + 1) - before;
    const bool straight = length(cross(along, at(i) - before)) <= near * length(along);
    if (straight) loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    else ++i;
  }
}

// Newell's normal: good also where the corners are a little off their plane.
Polyhedron::Face face_of(const std::vector<Vec3>& vertices, const Loop& loop) {
  Vec3 sum, middle;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = vertices[static_cast<std::size_t>(loop[i])], b = vertices[static_cast<std::size_t>(loop[(i + 1) % loop.size()])];
    const Vec3 origin = vertices[static_cast<std::size_t>(loop[0])];
    sum += cross(a - origin, b - origin);
    middle += a;
  }
  Polyhedron::Face face;
  face.normal = normalized(sum);
  face.offset = dot(face.normal, middle / static_cast<double>(loop.size()));
  return face;
}

void add_face(Polyhedron& made, const Loop& loop) {
  Polyhedron::Face face = face_of(made.vertices, loop);
  face.first = static_cast<int>(made.loops.size());
  face.count = static_cast<int>(loop.size());
  made.loops.insert(made.loops.end(), loop.begin(), loop.end());
  made.faces.push_back(face);
}

void find_edges(Polyhedron& made) {
  std::map<std::pair<int, int>, int> face_left_of;
  for (std::size_t f = 0; f < made.faces.size(); ++f) {
    const Polyhedron::Face& face = made.faces[f];
    for (int i = 0; i < face.count; ++i) {
      const int from = made.loops[static_cast<std::size_t>(face.first + i)];
      const int to = made.loops[static_cast<std::size_t>(face.first + (i + 1) % face.count)];
      const auto other = face_left_of.find({to, from});
      if (other == face_left_of.end()) face_left_of[{from, to}] = static_cast<int>(f);
      else made.edges.push_back({to, from, other->second, static_cast<int>(f)});
    }
  }
}

// Those that no face uses: corners within a flat or a straight edge.
void drop_unused_vertices(Polyhedron& made) {
  std::vector<int> renamed(made.vertices.size(), -1);
  std::vector<Vec3> kept;
  for (int& vertex : made.loops) {
    int& name = renamed[static_cast<std::size_t>(vertex)];
    if (name < 0) {
      name = static_cast<int>(kept.size());
      kept.push_back(made.vertices[static_cast<std::size_t>(vertex)]);
    }
    vertex = name;
  }
  made.vertices = std::move(kept);
}

void finish(Polyhedron& made) {
  drop_unused_vertices(made);
  find_edges(made);
  for (const Vec3 p : made.vertices) made.center += p / static_cast<double>(made.vertices.size());
}

}  // namespace

Polyhedron make_polyhedron(const std::vector<Triangle>& hull) {
  Polyhedron made;
  if (hull.empty()) return made;
  const double near = kSame * size_of(hull), concave = kConcave * size_of(hull);
  struct Group {
    Vec3 normal;  // of its largest triangle, with the length of twice its area
    double offset = 0;
    std::vector<Loop> triangles;
  };
  std::vector<Group> groups;

  // Large triangles first: they know the plane best, and slivers join them.
  std::vector<Triangle> sorted = hull;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Triangle& s, const Triangle& t) {
    return length(area_normal(s.a, s.b, s.c)) > length(area_normal(t.a, t.b, t.c));
  });
  for (const Triangle& t : sorted) {
    if (is_sliver(t, near)) continue;
    const Loop corners{vertex_at(made, t.a, near), vertex_at(made, t.b, near), vertex_at(made, t.c, near)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    const Vec3 normal = normalized(area_normal(t.a, t.b, t.c));
    const auto flat = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      if (dot(group.normal, normal) < 0.5) return false;
      return std::all_of(corners.begin(), corners.end(), [&](int c) {
        const double above = dot(group.normal, made.vertices[static_cast<std::size_t>(c)]) - group.offset;
        return above >= -near && above <= concave;
      });
    });
    if (flat != groups.end()) flat->triangles.push_back(corners);
    else groups.push_back({normal, dot(normal, t.a), {corners}});
  }

  for (const Group& group : groups) {
    Loop loop = outline(group.triangles);
    drop_straight_corners(made.vertices, loop, near);
    if (loop.size() >= 3) add_face(made, loop);
  }
  finish(made);
  return made;
}

Polyhedron make_box_polyhedron(Vec3 half) {
  Polyhedron made;
  for (int i = 0; i < 8; ++i)
    made.vertices.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  for (const Loop& loop : {Loop{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) add_face(made, loop);
  finish(made);
  return made;
}

}  // namespace tumble::pairs
