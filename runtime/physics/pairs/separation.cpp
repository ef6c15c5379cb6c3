#include "physics/pairs/separation.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

constexpr double kNone = -1e300;
// Edges at a smaller angle (squared sine) give no direction of their own; faces then separate as well.
constexpr double kParallel = 1e-5;
constexpr double kEdgeRelative = 0.05, kEdgeAbsolute = 1e-5;
// Both sides of a mesh's triangles have their own normal and their edges are mostly within the mesh: another direction
// must be better than the triangle's by this, m, or a box that slides from one triangle to the next hits its rim.
constexpr double kRim = 0.002;

// In the world.
struct Side {
  Vec3 normal;
  double offset = 0;
};
struct Edge {
  Vec3 from, to, left, right;  // the normals beside it
  Vec3 out;                    // between them
};

Polyhedron two_sided_triangle() {
  Polyhedron flat;
  flat.vertices.resize(3);
  flat.faces = {{{}, 0, 0, 3}, {{}, 0, 0, 3}};
  flat.loops = {0, 1, 2};
  flat.edges = {{0, 1, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}};
  return flat;
}

// One vocabulary for boxes, polyhedra and triangles. What is joined to what is the same for all boxes and for all
// triangles, so that nothing is built here.
struct Facets {
  const Placed& placed;
  const Polyhedron* solid;
  const Vec3* vertices;
  Vec3 scale{1, 1, 1};
  Vec3 flat;               // a triangle's normal, in its frame

  explicit Facets(const Placed& given) : placed(given) {
    static const Polyhedron cube = make_box_polyhedron({1, 1, 1}), triangle = two_sided_triangle();
    const Convex& shape = placed.shape;
    solid = shape.kind == Convex::polyhedron ? shape.solid : shape.kind == Convex::box ? &cube : &triangle;
    vertices = solid->vertices.data();
    if (shape.kind == Convex::box) scale = shape.half;
    if (shape.kind != Convex::triangle) return;
    vertices = shape.corners;
    flat = normalized(cross(vertices[1] - vertices[0], vertices[2] - vertices[0]));
  }
  Vec3 vertex(int i) const { return placed.world(scaled(vertices[i], scale)); }
  Vec3 normal(int face) const {
    if (placed.shape.kind == Convex::triangle) return placed.turned(face == 0 ? flat : -flat);
    return placed.turned(solid->faces[static_cast<std::size_t>(face)].normal);
  }
  Side side(int face) const {
    const Vec3 out = normal(face);
    const Polyhedron::Face& made = solid->faces[static_cast<std::size_t>(face)];
    if (placed.shape.kind == Convex::polyhedron) return {out, made.offset + dot(out, placed.position)};
    return {out, dot(out, vertex(solid->loops[static_cast<std::size_t>(made.first)]))};
  }
  Edge edge(const Polyhedron::Edge& of) const {
    Edge made{vertex(of.from), vertex(of.to), normal(of.left), normal(of.right), {}};
    made.out = placed.shape.kind == Convex::triangle ? cross(made.to - made.from, made.left) : made.left + made.right;
    return made;
  }
};

struct Best {
  double distance = kNone;
  Vec3 normal;  // from the first shape outward
  Edge first, second;
};

// The face of one that lies furthest off the other. Stops at one beyond the margin.
Best best_face(const Facets& one, const Placed& other, double margin) {
  Best best;
  for (int face = 0; face < static_cast<int>(one.solid->faces.size()); ++face) {
    const Side side = one.side(face);
    const double d = dot(furthest(other, -side.normal), side.normal) - side.offset;
    if (d > best.distance) best.distance = d, best.normal = side.normal;
    if (d > margin) break;
  }
  return best;
}

// Do two edges make a face of the Minkowski difference? Where the arcs between their faces' normals cross on the unit
// sphere, b's taken with opposite sign (D. Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013).
bool make_a_face(const Edge& a, const Edge& b) {
  const Vec3 turn_a = a.from - a.to, turn_b = b.from - b.to;
  const double left_b = -dot(b.left, turn_a), right_b = -dot(b.right, turn_a);
  const double left_a = dot(a.left, turn_b), right_a = dot(a.right, turn_b);
  return left_b * right_b < 0 && left_a * right_a < 0 && left_b * right_a > 0;
}

void try_edges(const Edge& a, const Edge& b, Best& best) {
  if (!make_a_face(a, b)) return;
  const Vec3 da = a.to - a.from, db = b.to - b.from, across = cross(da, db);
  const double size2 = dot(across, across);
  if (size2 < kParallel * dot(da, da) * dot(db, db)) return;
  const Vec3 axis = across * ((dot(across, a.out) >= 0 ? 1 : -1) / std::sqrt(size2));
  const double d = dot(axis, b.from - a.from);
  if (d > best.distance) best = {d, axis, a, b};
}

Best best_edges(const Facets& a, const Facets& b, double margin) {
  // b's edges are turned into the world a batch at a time, without asking for memory.
  constexpr std::size_t kBatch = 32;
  Edge batch[kBatch];
  Best best;
  for (std::size_t first = 0; first < b.solid->edges.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, b.solid->edges.size() - first);
    for (std::size_t j = 0; j < count; ++j) batch[j] = b.edge(b.solid->edges[first + j]);
    for (const Polyhedron::Edge& each : a.solid->edges) {
      const Edge edge = a.edge(each);
      for (std::size_t j = 0; j < count; ++j) try_edges(edge, batch[j], best);
      if (best.distance > margin) return best;
    }
  }
  return best;
}

constexpr double kSameDirection = 0.985, kSameDistance = 0.012;  // cosine of 10 degrees; of the size

double smallest_of(const Placed& a, const Placed& b) { return std::min(size_of(a.shape), size_of(b.shape)); }

// What must be added to a triangle's own direction before it is compared.
double rim(const Convex& shape, double smallest) { return shape.kind == Convex::triangle ? std::min(kRim, 0.05 * smallest) : 0; }

}  // namespace

bool has_flat_faces(const Convex& shape) {
  return shape.kind == Convex::box || shape.kind == Convex::polyhedron || shape.kind == Convex::triangle;
}

bool nearly_same(Vec3 edges, double edges_distance, Vec3 face, double face_distance, double size) {
  const bool parted = edges_distance > 0 && face_distance <= 0;
  return !parted && edges_distance - face_distance < kSameDistance * size && std::abs(dot(edges, face)) > kSameDirection;
}

Separation::Kind preferred(double face_a, double face_b, double edges, double size, Separation::Kind before) {
  const double face = std::max(face_a, face_b), off = kEdgeRelative * std::abs(face) + kEdgeAbsolute * size;
  if (edges > face + (before == Separation::edges ? 0 : off)) return Separation::edges;
  const double close = kEdgeAbsolute * size;
  if (before == Separation::face_a && face_a > face_b - close) return Separation::face_a;
  if (before == Separation::face_b && face_b > face_a - close) return Separation::face_b;
  return face_a >= face_b ? Separation::face_a : Separation::face_b;
}

Separation separation(const Placed& a, const Placed& b, double margin, Separation::Kind before) {
  if (a.shape.kind == Convex::box && b.shape.kind == Convex::box) return box_separation(a, b, margin, before);
  const Facets facets_a(a), facets_b(b);
  const Best face_a = best_face(facets_a, b, margin);
  if (face_a.distance > margin) return {};
  const Best face_b = best_face(facets_b, a, margin);
  if (face_b.distance > margin) return {};
  Best edges = best_edges(facets_a, facets_b, margin);
  if (edges.distance > margin) return {};
  const double smallest = smallest_of(a, b);
  for (const Best* face : {&face_a, &face_b})
    if (nearly_same(edges.normal, edges.distance, face->normal, face->distance, smallest)) edges.distance = -1e300;
  const bool apart = std::max({face_a.distance, face_b.distance, edges.distance}) > 0;
  const double rim_a = apart ? 0 : rim(a.shape, smallest), rim_b = apart ? 0 : rim(b.shape, smallest);
  Separation found;
  found.kind = preferred(face_a.distance + rim_a, face_b.distance + rim_b, edges.distance, smallest, before);
  const Best& best = found.kind == Separation::face_a ? face_a : found.kind == Separation::face_b ? face_b : edges;
  found.normal = found.kind == Separation::face_b ? best.normal : -best.normal;
  found.distance = best.distance;
  if (found.kind == Separation::edges) {
    found.edge_a[0] = best.first.from, found.edge_a[1] = best.first.to;
    found.edge_b[0] = best.second.from, found.edge_b[1] = best.second.to;
  }
  return found;
}

}  // namespace tumble::pairs
