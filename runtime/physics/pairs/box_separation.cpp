#include <algorithm>

#include "physics/pairs/separation.h"

namespace tumble::pairs {

namespace {

// Edges at a smaller angle (squared sine) give no direction of their own; faces then separate as well.
constexpr double kParallel = 1e-5;
constexpr double kNone = -1e300;

struct Boxes {
  const Placed &a, &b;
  double r[3][3];      // dot(a.axis[i], b.axis[j])
  double size[3][3];   // of those
  double ta[3], tb[3]; // from a's centre to b's, in either's axes
  double ha[3], hb[3];
  Boxes(const Placed& first, const Placed& second)
      : a(first), b(second), ha{a.shape.half.x, a.shape.half.y, a.shape.half.z}, hb{b.shape.half.x, b.shape.half.y, b.shape.half.z} {
    const Vec3 t = b.position - a.position;
    for (int i = 0; i < 3; ++i) {
      ta[i] = dot(t, a.axis[i]);
      tb[i] = dot(t, b.axis[i]);
      for (int j = 0; j < 3; ++j) size[i][j] = std::abs(r[i][j] = dot(a.axis[i], b.axis[j]));
    }
  }
  double along_face_a(int i) const {
    return std::abs(ta[i]) - ha[i] - (hb[0] * size[i][0] + hb[1] * size[i][1] + hb[2] * size[i][2]);
  }
  double along_face_b(int j) const {
    return std::abs(tb[j]) - hb[j] - (ha[0] * size[0][j] + ha[1] * size[1][j] + ha[2] * size[2][j]);
  }
  // Along the cross product of a's axis i and b's axis j.
  double along_edges(int i, int j) const {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const double length2 = 1 - r[i][j] * r[i][j];
    if (length2 < kParallel) return kNone;
    const double t = ta[i2] * r[i1][j] - ta[i1] * r[i2][j];
    const double ra = ha[i1] * size[i2][j] + ha[i2] * size[i1][j], rb = hb[j1] * size[i][j2] + hb[j2] * size[i][j1];
    return (std::abs(t) - ra - rb) / std::sqrt(length2);
  }
};

// The edge of a box along its axis k that lies furthest in a direction.
void put_edge(const Placed& box, int k, Vec3 direction, Vec3* ends) {
  const double half[3] = {box.shape.half.x, box.shape.half.y, box.shape.half.z};
  Vec3 middle = box.position;
  for (int i = 0; i < 3; ++i)
    if (i != k) middle += box.axis[i] * (dot(box.axis[i], direction) >= 0 ? half[i] : -half[i]);
  ends[0] = middle - box.axis[k] * half[k];
  ends[1] = middle + box.axis[k] * half[k];
}

// The normal goes from b to a, against the way from a to b.
Vec3 against(Vec3 axis, double along) { return along >= 0 ? -axis : axis; }

}  // namespace

Separation box_separation(const Placed& a, const Placed& b, double margin, Separation::Kind before) {
  const Boxes boxes(a, b);
  int best_a = 0, best_b = 0, edge_i = 0, edge_j = 0;
  double face_a = kNone, face_b = kNone, edges = kNone;
  for (int i = 0; i < 3; ++i) {
    const double d = boxes.along_face_a(i);
    if (d > margin) return {};
    if (d > face_a) face_a = d, best_a = i;
  }
  for (int j = 0; j < 3; ++j) {
    const double d = boxes.along_face_b(j);
    if (d > margin) return {};
    if (d > face_b) face_b = d, best_b = j;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double d = boxes.along_edges(i, j);
      if (d > margin) return {};
      if (d > edges) edges = d, edge_i = i, edge_j = j;
    }

  if (edges > kNone) {
    const Vec3 across = normalized(cross(a.axis[edge_i], b.axis[edge_j]));
    const double size = std::min(size_of(a.shape), size_of(b.shape));
    if (nearly_same(across, edges, a.axis[best_a], face_a, size) || nearly_same(across, edges, b.axis[best_b], face_b, size)) edges = kNone;
  }
  Separation found;
  found.kind = preferred(face_a, face_b, edges, std::min(size_of(a.shape), size_of(b.shape)), before);
  switch (found.kind) {
    case Separation::none: break;
    case Separation::face_a:
      found.normal = against(a.axis[best_a], boxes.ta[best_a]);
      found.distance = face_a;
      break;
    case Separation::face_b:
      found.normal = against(b.axis[best_b], boxes.tb[best_b]);
      found.distance = face_b;
      break;
    case Separation::edges: {
      const Vec3 axis = normalized(cross(a.axis[edge_i], b.axis[edge_j]));
      found.normal = against(axis, dot(axis, b.position - a.position));
      found.distance = edges;
      put_edge(a, edge_i, -found.normal, found.edge_a);
      put_edge(b, edge_j, found.normal, found.edge_b);
    }
  }
  return found;
}

}  // namespace tumble::pairs
