#include <algorithm>

#include "physics/pairs/nearest.h"

namespace tumble::pairs {

namespace {

constexpr int kMostPoints = 100, kMostFaces = 2 * kMostPoints, kMostRim = 64;
// Of the size: how much further out a new point must lie to be taken.
constexpr double kProgress = 1e-9;

struct Triangular {
  int corner[3] = {};
  Vec3 normal;            // outward; zero of a sliver
  double distance = 0;    // of its plane from the origin, negative where the origin is outside
};

// A convex body within the Minkowski difference that grows where it is nearest to the origin.
struct Polytope {
  int point_count = 0, face_count = 0;
  bool no_room = false;
  Difference points[kMostPoints];
  Triangular faces[kMostFaces];

  Vec3 at(int i) const { return points[i].at; }
  bool full() const { return no_room || point_count == kMostPoints; }
  void add_face(int a, int b, int c) {
    Triangular face{{a, b, c}, normalized(cross(at(b) - at(a), at(c) - at(a))), 0};
    face.distance = face.normal == Vec3{} ? 1e300 : dot(face.normal, at(a));
    faces[face_count++] = face;
  }
  int nearest() const {
    int best = 0;
    for (int i = 1; i < face_count; ++i)
      if (faces[i].distance < faces[best].distance) best = i;
    return best;
  }
};

// Points in general position out of a simplex that may be a point, a segment or a triangle.
bool fill(const Placed& a, const Placed& b, Simplex& s, double near) {
  const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto offer = [&](Vec3 direction, auto off) {
    for (const double sign : {1.0, -1.0}) {
      const Difference point = difference(a, b, direction * sign);
      if (off(point.at) > near) {
        s.points[s.count++] = point;
        return true;
      }
    }
    return false;
  };
  const Vec3 p = s.points[0].at;
  if (s.count > 1 && distance(s.points[1].at, p) <= near) s.count = 1;
  if (s.count > 2 && length(cross(s.points[2].at - p, normalized(s.points[1].at - p))) <= near) s.count = 2;
  for (int i = 0; i < 3 && s.count == 1; ++i) offer(axes[i], [&](Vec3 at) { return distance(at, p); });
  if (s.count == 1) return false;
  const Vec3 along = normalized(s.points[1].at - p);
  for (int i = 0; i < 3 && s.count == 2; ++i) {
    const Vec3 across = cross(along, axes[i]);
    if (length(across) > 0.1) offer(across, [&](Vec3 at) { return length(cross(at - p, along)); });
  }
  if (s.count == 2) return false;
  const Vec3 normal = normalized(cross(along, s.points[2].at - p));
  const auto off_plane = [&](Vec3 at) { return std::abs(dot(at - p, normal)); };
  if (s.count == 4 && off_plane(s.points[3].at) <= near) s.count = 3;
  if (s.count == 3) offer(normal, off_plane);
  return s.count == 4;
}

void begin(Polytope& body, const Simplex& s) {
  for (int i = 0; i < 4; ++i) body.points[i] = s.points[i];
  body.point_count = 4;
  const Vec3 normal = cross(body.at(1) - body.at(0), body.at(2) - body.at(0));
  if (dot(normal, body.at(3) - body.at(0)) > 0) std::swap(body.points[1], body.points[2]);
  body.add_face(0, 1, 2);
  body.add_face(0, 3, 1);
  body.add_face(1, 3, 2);
  body.add_face(2, 3, 0);
}

struct Rim {
  int count = 0;
  int from[kMostRim], to[kMostRim];
  bool full = false;
  // An edge that two removed faces share is on the rim of neither.
  void toggle(int a, int b) {
    for (int i = 0; i < count; ++i)
      if (from[i] == b && to[i] == a) {
        --count;
        from[i] = from[count], to[i] = to[count];
        return;
      }
    if (count == kMostRim) full = true;
    else from[count] = a, to[count++] = b;
  }
};

// Replaces the faces that see the new point by a fan to it.
void grow(Polytope& body, int nearest, const Difference& point, double near) {
  Rim rim;
  bool seen[kMostFaces] = {};
  for (int i = 0; i < body.face_count; ++i) {
    const Triangular& face = body.faces[i];
    seen[i] = i == nearest || dot(face.normal, point.at - body.at(face.corner[0])) > near;
    if (!seen[i]) continue;
    for (int k = 0; k < 3; ++k) rim.toggle(face.corner[k], face.corner[(k + 1) % 3]);
  }
  if (rim.full || body.face_count + rim.count > kMostFaces) {
    body.no_room = true;
    return;
  }
  int kept = 0;
  for (int i = 0; i < body.face_count; ++i)
    if (!seen[i]) body.faces[kept++] = body.faces[i];
  body.face_count = kept;
  const int added = body.point_count++;
  body.points[added] = point;
  for (int i = 0; i < rim.count; ++i) body.add_face(rim.from[i], rim.to[i], added);
}

// The point of a face below the origin as a mix of its corners; a negative share where it lies beside the face.
struct Shares {
  double of[3];
  double least() const { return std::min({of[0], of[1], of[2]}); }
};
Shares shares(const Polytope& body, const Triangular& face) {
  const Vec3 foot = face.normal * face.distance, a = body.at(face.corner[0]), b = body.at(face.corner[1]), c = body.at(face.corner[2]);
  const double whole = dot(cross(b - a, c - a), face.normal);
  const double u = dot(cross(b - foot, c - foot), face.normal) / whole, v = dot(cross(c - foot, a - foot), face.normal) / whole;
  return {{u, v, 1 - u - v}};
}

// A flat of the difference may be several faces: of those as near as this one, the one that has the foot.
void put_result(const Polytope& body, const Triangular& nearest, double near, Nearest& out) {
  const Triangular* chosen = &nearest;
  Shares share = shares(body, nearest);
  for (int i = 0; i < body.face_count && share.least() < 0; ++i) {
    if (body.faces[i].distance > nearest.distance + near) continue;
    const Shares other = shares(body, body.faces[i]);
    if (other.least() > share.least()) share = other, chosen = &body.faces[i];
  }
  double sum = 0;
  for (double& part : share.of) sum += part = std::max(part, 0.0);
  out.normal = -nearest.normal;
  out.separation = -nearest.distance;
  out.on_a = out.on_b = {};
  for (int k = 0; k < 3; ++k) {
    out.on_a += body.points[chosen->corner[k]].on_a * (share.of[k] / sum);
    out.on_b += body.points[chosen->corner[k]].on_b * (share.of[k] / sum);
  }
}

}  // namespace

bool penetration(const Placed& a, const Placed& b, const Simplex& start, Nearest& out) {
  const double size = size_of(a.shape) + size_of(b.shape);
  Simplex simplex = start;
  if (!fill(a, b, simplex, 1e-7 * size)) return false;
  Polytope body;
  begin(body, simplex);
  for (;;) {
    const int nearest = body.nearest();
    const Triangular& face = body.faces[nearest];
    if (face.distance == 1e300) return false;
    const Difference further = difference(a, b, face.normal);
    const bool there = dot(further.at, face.normal) - face.distance <= kProgress * size;
    if (there || body.full()) return put_result(body, face, 1e-8 * size, out), true;
    grow(body, nearest, further, 1e-12 * size);
  }
}

}  // namespace tumble::pairs
