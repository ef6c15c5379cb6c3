// Rays, casts and overlaps.
#include <algorithm>

#include "physics/bullet/closest.h"
#include "physics/bullet/each_convex.h"
#include "physics/bullet/impl.h"
#include "physics/rays.h"

namespace tumble {

namespace {

// Does the body's part that this object stands for answer?
bool answers(const btCollisionObject* object, const QueryFilter& filter) {
  const BodyState& body = *state_of(object);
  if (!(body.group & filter.groups) || (is_ghost(object) && !filter.triggers)) return false;
  if (!is_ghost(object) && body.solids->empty()) return false;
  return !filter.accept || filter.accept(body.id);
}

const std::vector<Piece>& pieces_of(const btCollisionObject* object) {
  const BodyState& body = *state_of(object);
  return (is_ghost(object) ? *body.triggers : *body.solids).pieces();
}

// Everything whose box the swept box meets. An infinite way ends where the world does.
std::vector<const btCollisionObject*> along(const Boxes& boxes, Vec3 origin, Vec3 direction, double& length, Vec3 low, Vec3 high,
                                            const QueryFilter& filter) {
  length = std::min(length, tumble::length(origin) + boxes.reach() + distance(low, high) + 1);
  std::vector<const btCollisionObject*> found;
  boxes.each_along(origin, direction, length, low, high, [&](const Occupant& occupant) {
    if (answers(occupant.object, filter)) found.push_back(occupant.object);
  });
  return found;
}

std::vector<const btCollisionObject*> within_box(const Boxes& boxes, const btVector3& low, const btVector3& high, const QueryFilter& filter) {
  std::vector<const btCollisionObject*> found;
  boxes.each_in(btDbvtVolume::FromMM(low, high), true, [&](const Occupant& occupant) {
    if (answers(occupant.object, filter)) found.push_back(occupant.object);
  });
  return found;
}

struct NearestTriangle final : btTriangleCallback {
  explicit NearestTriangle(const Ray& given) : ray(given) {}
  void processTriangle(btVector3* t, int, int) override {
    const auto hit = ray_triangle(ray, from_bullet(t[0]), from_bullet(t[1]), from_bullet(t[2]));
    if (hit && (!best || hit->distance < best->distance)) best = hit;
  }
  const Ray& ray;
  std::optional<RayHit> best;
};

// In the piece's own frame.
std::optional<RayHit> ray_piece(const Piece& piece, const Ray& ray, double length) {
  const btCollisionShape& shape = *piece.shape;
  switch (shape.getShapeType()) {
    case SPHERE_SHAPE_PROXYTYPE: return ray_sphere(ray, static_cast<const btSphereShape&>(shape).getRadius());
    case BOX_SHAPE_PROXYTYPE: return ray_box(ray, from_bullet(static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin()));
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return ray_capsule(ray, capsule.getRadius(), capsule.getHalfHeight());
    }
    case CYLINDER_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btCylinderShape&>(shape).getHalfExtentsWithMargin();
      return ray_cylinder(ray, half.x(), half.y());
    }
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      return ray_cone(ray, cone.getRadius(), cone.getHeight());
    }
    case CONVEX_HULL_SHAPE_PROXYTYPE: return ray_planes(ray, *piece.planes);
    default: break;
  }
  NearestTriangle nearest(ray);
  auto& mesh = const_cast<btBvhTriangleMeshShape&>(static_cast<const btBvhTriangleMeshShape&>(shape));
  mesh.performRaycast(&nearest, to_bullet(ray.origin), to_bullet(ray.origin + ray.direction * length));
  return nearest.best;
}

std::optional<QueryHit> ray_object(const btCollisionObject* object, const Ray& ray, double length) {
  std::optional<QueryHit> best;
  for (const Piece& piece : pieces_of(object)) {
    const Pose pose = from_bullet(object->getWorldTransform()) * from_bullet(piece.local);
    const Pose back = inverse(pose);
    const Ray local{conjugate(pose.rotation) * (ray.origin - pose.position), back.rotation * ray.direction};
    const auto hit = ray_piece(piece, local, length);
    if (!hit || hit->distance > length || (best && hit->distance >= best->distance)) continue;
    best = QueryHit{state_of(object)->id, piece.collider, ray.origin + ray.direction * hit->distance,
                    hit->inside ? -ray.direction : pose.rotation * hit->normal, hit->distance, hit->inside};
  }
  return best;
}

struct Found {
  std::uint32_t serial;
  QueryHit hit;
};

// Nearest first; at one distance the older body.
std::vector<QueryHit> sorted(std::vector<Found>& found) {
  std::stable_sort(found.begin(), found.end(), [](const Found& x, const Found& y) {
    return x.hit.distance != y.hit.distance ? x.hit.distance < y.hit.distance : x.serial < y.serial;
  });
  std::vector<QueryHit> hits;
  for (const Found& entry : found) hits.push_back(entry.hit);
  return hits;
}

Vec3 checked_direction(const char* call, Vec3 direction) {
  if (direction == Vec3{}) fail(call, ": direction must not be zero (got 0, 0, 0)");
  return normalized(direction);
}

// The one convex shape of a cast or overlap.
struct Probe {
  explicit Probe(const char* call, const Shape& shape) : parts(make_parts(shape)) {
    if (parts->shapes.size() != 1 || !parts->shapes[0]->isConvex())
      fail(call, ": shape '", enum_names(ShapeKind{})[static_cast<std::size_t>(shape.shape)],
           "' cannot be used here; take a sphere, box, capsule, cylinder, cone, pyramid or hull");
  }
  const btConvexShape& shape() const { return static_cast<const btConvexShape&>(*parts->shapes[0]); }
  btTransform at(const Pose& pose) const { return to_bullet(Pose{pose.position, normalized(pose.rotation)} * parts->poses[0]); }
  std::unique_ptr<ShapeParts> parts;
};

}  // namespace

std::vector<QueryHit> World::raycast_all(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter) const {
  const Ray ray{origin, checked_direction("physics.raycast_all", direction)};
  std::vector<Found> found;
  for (const btCollisionObject* object : along(impl_->overlaps.boxes(), origin, ray.direction, length, {}, {}, filter))
    if (const auto hit = ray_object(object, ray, length)) found.push_back({state_of(object)->serial, *hit});
  return sorted(found);
}

std::optional<QueryHit> World::raycast(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter) const {
  const Ray ray{origin, checked_direction("physics.raycast", direction)};
  std::optional<QueryHit> best;
  std::uint32_t serial = 0;
  for (const btCollisionObject* object : along(impl_->overlaps.boxes(), origin, ray.direction, length, {}, {}, filter)) {
    const auto hit = ray_object(object, ray, length);
    if (!hit) continue;
    const std::uint32_t age = state_of(object)->serial;
    if (best && (hit->distance > best->distance || (hit->distance == best->distance && age > serial))) continue;
    best = hit;
    serial = age;
  }
  return best;
}

bool World::raycast_any(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter) const {
  const Ray ray{origin, checked_direction("physics.raycast_any", direction)};
  const auto objects = along(impl_->overlaps.boxes(), origin, ray.direction, length, {}, {}, filter);
  return std::any_of(objects.begin(), objects.end(), [&](const auto* object) { return ray_object(object, ray, length).has_value(); });
}

std::optional<QueryHit> World::cast(const Shape& shape, const Pose& from, Vec3 direction, double length, const QueryFilter& filter) const {
  const Vec3 way = checked_direction("physics.cast", direction);
  const Probe probe("physics.cast", shape);
  const btTransform start = probe.at(from);
  btVector3 low, high;
  probe.shape().getAabb(start, low, high);
  const auto objects = along(impl_->overlaps.boxes(), from_bullet(start.getOrigin()), way, length, from_bullet(low - start.getOrigin()),
                             from_bullet(high - start.getOrigin()), filter);
  const btVector3 shift = to_bullet(way * length);
  btVector3 all_low = low, all_high = high;
  all_low.setMin(low + shift);
  all_high.setMax(high + shift);

  std::vector<Found> found;
  for (const btCollisionObject* object : objects)
    for (const Piece& piece : pieces_of(object))
      each_convex(piece, object->getWorldTransform() * piece.local, all_low, all_high,
                  [&](const btConvexShape& other, const btTransform& at) {
                    const auto hit = meet(probe.shape(), start, way, length, other, at);
                    if (!hit) return;
                    const BodyState& body = *state_of(object);
                    found.push_back({body.serial, {body.id, piece.collider, hit->point, hit->normal, hit->distance, hit->inside}});
                  });
  const std::vector<QueryHit> hits = sorted(found);
  return hits.empty() ? std::nullopt : std::optional(hits[0]);
}

std::vector<QueryHit> World::penetrations(const Shape& shape, const Pose& at, double within, const QueryFilter& filter) const {
  const Probe probe("physics.penetrations", shape);
  const btTransform place = probe.at(at);
  btVector3 low, high;
  probe.shape().getAabb(place, low, high);
  low -= btVector3(within, within, within);
  high += btVector3(within, within, within);

  std::vector<Found> found;
  for (const btCollisionObject* object : within_box(impl_->overlaps.boxes(), low, high, filter)) {
    for (const Piece& piece : pieces_of(object)) {
      each_convex(piece, object->getWorldTransform() * piece.local, low, high,
                  [&](const btConvexShape& other, const btTransform& other_at) {
                    const auto near = closest(probe.shape(), place, other, other_at, within);
                    if (!near) return;
                    const BodyState& body = *state_of(object);
                    found.push_back({body.serial, {body.id, piece.collider, near->point, near->normal, near->distance, near->distance < 0}});
                  });
    }
  }

  // Triangles of one face, and links of a ring, would tell the same: of hits on one collider that point the same way
  // the deepest is kept.
  std::vector<QueryHit> kept;
  for (const QueryHit& hit : sorted(found)) {
    const bool same = std::any_of(kept.begin(), kept.end(), [&](const QueryHit& other) {
      return other.body == hit.body && other.collider == hit.collider && dot(other.normal, hit.normal) > 0.999;
    });
    if (!same) kept.push_back(hit);
  }
  return kept;
}

std::vector<BodyId> World::overlap(const Shape& shape, const Pose& at, const QueryFilter& filter) const {
  std::vector<const BodyState*> bodies;
  for (const QueryHit& hit : penetrations(shape, at, 0, filter)) bodies.push_back(&impl_->body(hit.body));
  std::sort(bodies.begin(), bodies.end(), [](const BodyState* x, const BodyState* y) { return x->serial < y->serial; });
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  std::vector<BodyId> ids;
  for (const BodyState* body : bodies) ids.push_back(body->id);
  return ids;
}

}  // namespace tumble
