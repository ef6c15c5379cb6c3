#include "engine/colliders.h"

#include "engine/shape_files.h"
#include "scene/node.h"

namespace tumble {

namespace {

// Triangles have no inside, so that they could neither fall nor hold anything.
void refuse_moving_triangles(const Shape& shape, BodyType type, const std::string& call) {
  if (shape.file.empty() || shape.shape == ShapeKind::hull || type != BodyType::dynamic) return;
  fail(call, ": a ", enum_names(shape.shape)[static_cast<std::size_t>(shape.shape)], " from a file ('", shape.file,
       "') cannot be the collider of a dynamic body; give body = \"static\", or colliders = { shape = \"hull\", file = \"", shape.file, "\" }");
}

ColliderDef stretched(const ColliderDef& collider, Vec3 scale) {
  // A turned collider under unequal scale is stretched along its own axes, as a child node would be.
  const Transform local = Transform{{}, {}, scale} * Transform{collider.offset, collider.rotation, {1, 1, 1}};
  ColliderDef result = collider;
  result.shape = scaled(collider.shape, local.scale);
  result.offset = local.position;
  return result;
}

ColliderDef fitted_collider(const BodyDef& def, const std::optional<Shape>& mesh, const std::string& call) {
  ColliderDef collider;
  if (def.fit == Fit::node) return collider;  // the default shape, a box of 1 m
  if (!mesh)
    fail(call, ": body needs a mesh or colliders: give the node mesh = \"box\", or body = { colliders = { shape = \"box\" } }");
  collider.shape = settled(*mesh);
  if (collider.shape.shape == ShapeKind::mesh && (def.type == BodyType::dynamic || def.trigger)) collider.shape.shape = ShapeKind::hull;
  return collider;
}

}  // namespace

BodyDef fitted(const BodyDef& def, const std::optional<Shape>& mesh, Vec3 scale, const WithPoints& with_points, const std::string& call) {
  BodyDef result = def;
  if (def.colliders.empty()) result.colliders.push_back(fitted_collider(def, mesh, call));
  for (ColliderDef& collider : result.colliders) {
    collider.shape = settled(collider.shape);
    refuse_moving_triangles(collider.shape, def.type, call);
    collider.shape = with_points(collider.shape);
    collider = stretched(collider, scale);
  }
  if (def.center_of_mass) result.center_of_mass = scaled(*def.center_of_mass, scale);
  return result;
}

}  // namespace tumble
