#include "physics/bullet/shapes.h"

#include <algorithm>
#include <sstream>

#include "physics/solids.h"

namespace tumble {

namespace {

// Bullet rounds corners by this much; enough for its iterations to be stable, too little to see.
double margin_of(double smallest_half) { return std::min(1e-3, 0.02 * smallest_half); }

void push(ShapeParts& parts, std::unique_ptr<btCollisionShape> shape, const Pose& pose = {}) {
  parts.shapes.push_back(std::move(shape));
  parts.poses.push_back(pose);
}

std::unique_ptr<btCollisionShape> make_box(Vec3 half) {
  auto box = std::make_unique<btBoxShape>(to_bullet(half));
  box->setMargin(margin_of(std::min({half.x, half.y, half.z})));
  return box;
}

std::unique_ptr<btCollisionShape> make_cylinder(double radius, double height) {
  auto cylinder = std::make_unique<btCylinderShape>(btVector3(radius, height / 2, radius));
  cylinder->setMargin(margin_of(std::min(radius, height / 2)));
  return cylinder;
}

std::unique_ptr<btCollisionShape> make_cone(double radius, double height) {
  auto cone = std::make_unique<btConeShape>(radius, height);
  cone->setMargin(margin_of(std::min(radius, height / 2)));
  return cone;
}

std::vector<Plane> planes_of(const std::vector<Triangle>& faces) {
  std::vector<Plane> planes;
  for (const Triangle& face : faces) {
    const Vec3 normal = normalized(cross(face.b - face.a, face.c - face.a));
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const Plane& p) { return dot(p.normal, normal) > 1 - 1e-14; });
    if (!known && !(normal == Vec3{})) planes.push_back({normal, dot(normal, face.a)});
  }
  return planes;
}

void push_hull(ShapeParts& parts, const std::vector<Vec3>& points) {
  const std::vector<Triangle> faces = convex_hull(points);
  if (faces.empty())
    fail("collider: a hull needs at least 4 points that are not in one plane (got ", points.size(), " points)");
  auto hull = std::make_unique<btConvexHullShape>();
  Vec3 low = faces[0].a, high = low;
  for (const Triangle& face : faces)
    for (const Vec3 p : {face.a, face.b, face.c}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      bool known = false;
      for (int i = 0; i < hull->getNumPoints() && !known; ++i) known = from_bullet(hull->getUnscaledPoints()[i]) == p;
      if (!known) hull->addPoint(to_bullet(p), false);
    }
  const Vec3 half = (high - low) / 2;
  hull->recalcLocalAabb();
  hull->setMargin(margin_of(std::min({half.x, half.y, half.z})));
  parts.planes = planes_of(faces);
  parts.solid = pairs::make_polyhedron(faces);
  hull->setUserPointer(&parts.solid);
  push(parts, std::move(hull));
}

// A ring of capsules: enough that their line is a circle within 2 % of the tube's diameter, at least 8, at most 96.
void push_torus(ShapeParts& parts, const Shape& torus) {
  const double tube = torus.thickness / 2, off = std::min(0.5, 4 * 0.02 * tube / torus.radius);
  const int count = std::clamp(static_cast<int>(std::ceil(kPi / std::acos(1 - off))), 8, 96);
  const double corner = torus.radius * 2 / (1 + std::cos(kPi / count));  // corners outside, middles inside by the same
  const double chord = 2 * corner * std::sin(kPi / count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    const Vec3 out{std::cos(angle), 0, std::sin(angle)};
    const Quat turn = between({0, 1, 0}, cross(out, {0, 1, 0}));
    push(parts, std::make_unique<btCapsuleShape>(tube, chord), {out * (corner * std::cos(kPi / count)), turn});
  }
}

void push_mesh(ShapeParts& parts, const Shape& mesh) {
  const auto count = mesh.points.size();
  if (count == 0 || count % 3 != 0)
    fail("collider: a ", enum_names(ShapeKind{})[static_cast<std::size_t>(mesh.shape)], " takes its triangles from 'points', three each (got ",
         count, " points)");
  for (std::size_t i = 0; i < count; ++i) {
    parts.vertices.push_back(to_bullet(mesh.points[i]));
    parts.indices.push_back(static_cast<int>(i));
  }
  parts.triangles = std::make_unique<btTriangleIndexVertexArray>(
      static_cast<int>(count / 3), parts.indices.data(), static_cast<int>(3 * sizeof(int)), static_cast<int>(count),
      &parts.vertices[0].m_floats[0], static_cast<int>(sizeof(btVector3)));
  auto shape = std::make_unique<btBvhTriangleMeshShape>(parts.triangles.get(), true);
  shape->setMargin(1e-3);
  push(parts, std::move(shape));
}

std::string written(Vec3 v) {
  std::ostringstream text;
  text << v.x << ", " << v.y << ", " << v.z;
  return text.str();
}

// A script's shapes are checked when they are described; whoever else makes a body learns it here.
void check_size(const Shape& shape) {
  const std::string kind = enum_names(ShapeKind{})[static_cast<std::size_t>(shape.shape)];
  const auto above_0 = [&](const char* what, double value) {
    if (!(value > 0) || !std::isfinite(value)) fail("collider: the ", what, " of a ", kind, " must be above 0 (got ", value, "); give it in metres");
  };
  switch (shape.shape) {
    case ShapeKind::box:
    case ShapeKind::pyramid:
      if (!(shape.size.x > 0 && shape.size.y > 0 && shape.size.z > 0) || !is_finite(shape.size))
        fail("collider: the size of a ", kind, " must be above 0 along each axis (got ", written(shape.size), "); give it in metres");
      break;
    case ShapeKind::plane:
      if (!(shape.size.x > 0 && shape.size.z > 0) || !is_finite(shape.size))
        fail("collider: the size of a plane must be above 0 along x and z (got ", written(shape.size), "); give it in metres");
      break;
    case ShapeKind::torus: above_0("thickness", shape.thickness); [[fallthrough]];
    case ShapeKind::sphere: above_0("radius", shape.radius); break;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
      above_0("radius", shape.radius);
      above_0("height", shape.height);
      break;
    case ShapeKind::hull:
    case ShapeKind::mesh:
    case ShapeKind::height_field: break;  // theirs is that of their points
  }
}

double smallest_half(const Shape& shape) {
  switch (shape.shape) {
    case ShapeKind::plane: return plane_thickness(shape) / 2;
    case ShapeKind::torus: return shape.thickness / 2;
    case ShapeKind::cone:
    case ShapeKind::pyramid: {
      const Vec3 half = half_extents(shape);
      return std::min({half.x, half.y, half.z}) / 2;
    }
    default: {
      const Vec3 half = half_extents(shape);
      return std::min({half.x, half.y, half.z});
    }
  }
}

}  // namespace

std::unique_ptr<ShapeParts> make_parts(const Shape& shape) {
  check_size(shape);
  auto parts = std::make_unique<ShapeParts>();
  switch (shape.shape) {
    case ShapeKind::box: push(*parts, make_box(shape.size / 2)); break;
    case ShapeKind::sphere: push(*parts, std::make_unique<btSphereShape>(shape.radius)); break;
    case ShapeKind::capsule:
      push(*parts, std::make_unique<btCapsuleShape>(shape.radius, std::max(0.0, shape.height - 2 * shape.radius)));
      break;
    case ShapeKind::cylinder: push(*parts, make_cylinder(shape.radius, shape.height)); break;
    case ShapeKind::cone: push(*parts, make_cone(shape.radius, shape.height)); break;
    case ShapeKind::pyramid: push_hull(*parts, pyramid_points(shape)); break;
    case ShapeKind::plane: {
      const double t = plane_thickness(shape);
      push(*parts, make_box({shape.size.x / 2, t / 2, shape.size.z / 2}), {{0, -t / 2, 0}, {}});
      break;
    }
    case ShapeKind::torus: push_torus(*parts, shape); break;
    case ShapeKind::hull: push_hull(*parts, shape.points); break;
    case ShapeKind::mesh:
    case ShapeKind::height_field: push_mesh(*parts, shape); break;
  }
  return parts;
}

ShapeSet::ShapeSet(const BodyDef& def, bool triggers, const Pose& frame) {
  const Pose back = inverse(frame);
  for (std::size_t c = 0; c < def.colliders.size(); ++c) {
    const ColliderDef& collider = def.colliders[c];
    if (collider.trigger.value_or(def.trigger) != triggers) continue;
    parts_.push_back(make_parts(collider.shape));
    const ShapeParts& parts = *parts_.back();
    if (parts.triangles && def.type == BodyType::dynamic)
      fail("collider: a mesh works on static and kinematic bodies only; give a dynamic one shape = 'hull'");
    const Pose at = back * Pose{collider.offset, normalized(collider.rotation)};
    for (std::size_t i = 0; i < parts.shapes.size(); ++i)
      pieces_.push_back({parts.shapes[i].get(), to_bullet(at * parts.poses[i]), static_cast<int>(c), &parts.planes});
  }
  if (pieces_.empty()) return;

  if (pieces_.size() == 1 && pieces_[0].local == btTransform::getIdentity()) {
    root_ = const_cast<btCollisionShape*>(pieces_[0].shape);
    return;
  }
  compound_ = std::make_unique<btCompoundShape>(true, static_cast<int>(pieces_.size()));
  for (const Piece& piece : pieces_) compound_->addChildShape(piece.local, const_cast<btCollisionShape*>(piece.shape));
  root_ = compound_.get();
}

int ShapeSet::collider_of(int part, int index) const {
  if (pieces_.empty()) return 0;
  if (part >= 0)  // only meshes have parts; their index is the triangle's
    for (const Piece& piece : pieces_)
      if (piece.shape->isConcave()) return piece.collider;
  const bool known = compound_ && index >= 0 && index < static_cast<int>(pieces_.size());
  return pieces_[known ? static_cast<std::size_t>(index) : 0].collider;
}

double inner_radius(const BodyDef& def) {
  double radius = 1e18;
  for (const ColliderDef& collider : def.colliders) radius = std::min(radius, smallest_half(collider.shape));
  return def.colliders.empty() ? 0 : radius;
}

}  // namespace tumble
