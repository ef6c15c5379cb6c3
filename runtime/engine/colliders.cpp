#include "engine/colliders.h"

#include "scene/node.h"

namespace tumble {

namespace {

void refuse_files(const Shape& shape, const std::string& call) {
  if (!shape.file.empty())
    fail(call, ": a collider cannot be made from a file yet (", enum_names(shape.shape)[static_cast<std::size_t>(shape.shape)], " '",
         shape.file, "'); give body = { colliders = { shape = \"box\", size = ... } } or another simple shape");
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
  collider.shape = *mesh;
  return collider;
}

}  // namespace

BodyDef fitted(const BodyDef& def, const std::optional<Shape>& mesh, Vec3 scale, const std::string& call) {
  BodyDef result = def;
  if (def.colliders.empty()) result.colliders.push_back(fitted_collider(def, mesh, call));
  for (ColliderDef& collider : result.colliders) {
    refuse_files(collider.shape, call);
    collider = stretched(collider, scale);
  }
  if (def.center_of_mass) result.center_of_mass = scaled(*def.center_of_mass, scale);
  return result;
}

}  // namespace tumble
