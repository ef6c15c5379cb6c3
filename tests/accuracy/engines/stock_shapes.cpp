#include "accuracy/engines/stock_shapes.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

double volume(const Shape& shape) {
  const double disc = kPi * shape.radius * shape.radius;
  switch (shape.shape) {
    case ShapeKind::box: return shape.size.x * shape.size.y * shape.size.z;
    case ShapeKind::sphere: return disc * shape.radius * 4 / 3;
    case ShapeKind::capsule: return disc * (shape.radius * 4 / 3 + shape.height - 2 * shape.radius);
    case ShapeKind::cylinder: return disc * shape.height;
    case ShapeKind::cone: return disc * shape.height / 3;
    case ShapeKind::pyramid: return shape.size.x * shape.size.y * shape.size.z / 3;
    default: return 1;
  }
}

btScalar half(double x) { return static_cast<btScalar>(x / 2); }

}  // namespace

btCollisionShape* StockShapes::convex(const Shape& shape) {
  const auto radius = static_cast<btScalar>(shape.radius), height = static_cast<btScalar>(shape.height);
  switch (shape.shape) {
    case ShapeKind::box: return keep(new btBoxShape({half(shape.size.x), half(shape.size.y), half(shape.size.z)}));
    case ShapeKind::sphere: return keep(new btSphereShape(radius));
    case ShapeKind::capsule: return keep(new btCapsuleShape(radius, height - 2 * radius));
    case ShapeKind::cylinder: return keep(new btCylinderShape({radius, height / 2, radius}));
    case ShapeKind::cone: return keep(new btConeShape(radius, height));
    case ShapeKind::pyramid: {
      const btScalar x = half(shape.size.x), y = half(shape.size.y), z = half(shape.size.z);
      auto* hull = new btConvexHullShape;
      for (const btVector3& corner : {btVector3(-x, -y, -z), btVector3(x, -y, -z), btVector3(x, -y, z), btVector3(-x, -y, z), btVector3(0, y, 0)})
        hull->addPoint(corner);
      return keep(hull);
    }
    case ShapeKind::hull: {
      auto* hull = new btConvexHullShape;
      for (const Vec3& point : shape.points) hull->addPoint(to_stock(point));
      return keep(hull);
    }
    default: return nullptr;
  }
}

btCollisionShape* StockShapes::shape(const Shape& shape) {
  if (btCollisionShape* found = convex(shape)) return found;
  switch (shape.shape) {
    case ShapeKind::plane: {  // as ours: a slab below its surface
      auto* slab = new btCompoundShape;
      keep(slab);
      btTransform down(btQuaternion::getIdentity(), {0, btScalar(-0.05), 0});
      slab->addChildShape(down, keep(new btBoxShape({half(shape.size.x), btScalar(0.05), half(shape.size.z)})));
      return slab;
    }
    case ShapeKind::mesh:
    case ShapeKind::height_field: {
      meshes_.push_back(std::make_unique<btTriangleMesh>());
      for (std::size_t i = 0; i + 2 < shape.points.size(); i += 3)
        meshes_.back()->addTriangle(to_stock(shape.points[i]), to_stock(shape.points[i + 1]), to_stock(shape.points[i + 2]));
      if (shape.points.size() < 3) throw Missing{"meshes without triangles"};
      return keep(new btBvhTriangleMeshShape(meshes_.back().get(), true));
    }
    case ShapeKind::torus: throw Missing{"a torus in the suite's stock engine"};
    default: throw Missing{"this kind of shape"};
  }
}

btCollisionShape* StockShapes::of_body(const BodyDef& body, Vec3& center) {
  center = body.center_of_mass.value_or(Vec3{});
  if (!body.center_of_mass) {
    double whole = 0;
    Vec3 moment;
    for (const ColliderDef& c : body.colliders) {
      const double part = volume(c.shape) * c.density.value_or(1);
      whole += part;
      moment += c.offset * part;
    }
    if (whole > 0) center = moment / whole;
  }
  const bool single = body.colliders.size() == 1 && body.colliders[0].offset == center && body.colliders[0].rotation == Quat{};
  if (single) return shape(body.colliders[0].shape);
  auto* compound = new btCompoundShape;
  keep(compound);
  for (const ColliderDef& c : body.colliders) compound->addChildShape(to_stock(Pose{c.offset - center, c.rotation}), shape(c.shape));
  return compound;
}

double StockShapes::inner_radius(const BodyDef& body) {
  double radius = 1e9;
  for (const ColliderDef& c : body.colliders) {
    const Shape& s = c.shape;
    const bool sized = s.shape == ShapeKind::box || s.shape == ShapeKind::pyramid;
    if (sized) radius = std::min({radius, s.size.x / 2, s.size.y / 2, s.size.z / 2});
    else radius = std::min({radius, s.radius, s.shape == ShapeKind::sphere ? s.radius : s.height / 2});
  }
  return radius;
}

}  // namespace tumble::accuracy
