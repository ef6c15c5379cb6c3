#include "physics/bullet/mesh_pair.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>

#include "physics/bullet/convex_pair.h"

namespace tumble {

namespace {

// Cosine of the angle between a triangle's normal and a contact's up to which it lies on its face.
constexpr double kOnFace = 1 - 1e-6;
// Normals within this cosine share a manifold.
constexpr double kAlike = 0.8;
// What is deeper than this below a face, over the size, is not above it but behind its edge.
constexpr double kSunk = 0.01;
// A point within this of a triangle lies on it, m.
constexpr double kOnTriangle = 1e-4;

// Triangles are given in the mesh's frame; all else is in the world.
class Collector final : public btTriangleCallback {
 public:
  Collector(const pairs::Convex& convex, const Pose& at, const Pose& mesh, double margin, btVector3 low, btVector3 high)
      : convex_(convex), at_(at), mesh_(mesh), margin_(margin), low_(low), high_(high) {}

  void processTriangle(btVector3* corners, int part, int index) override {
    if (!TestTriangleAgainstAabb2(corners, low_, high_)) return;
    const pairs::Convex triangle = pairs::make_triangle(from_bullet(corners[0]), from_bullet(corners[1]), from_bullet(corners[2]));
    pairs::Cache cache;
    pairs::Manifold found;
    if (!pairs::collide(convex_, at_, triangle, mesh_, margin_, cache, found)) return;
    const Vec3 *c = triangle.corners, flat = mesh_.rotation * normalized(cross(c[1] - c[0], c[2] - c[0]));
    const bool on_face = std::abs(dot(flat, found.normal)) > kOnFace;
    if (on_face) faces_.push_back(triangle);
    for (int i = 0; i < found.count; ++i) (on_face ? touches_ : rims_).push_back({found.points[i], found.normal, part, index});
    if (!on_face || (found.count == 1 && convex_.kind != pairs::Convex::sphere)) look_at_face(triangle, flat, part, index);
  }

  // Of points at edges and corners only those that are on no triangle which is met by its face: edges within a flat, or
  // beside a hollow, are no edges to what touches the flat itself.
  std::vector<Touch>& touches() {
    for (const Touch& rim : rims_)
      if (std::none_of(faces_.begin(), faces_.end(), [&](const pairs::Convex& face) { return holds(face, rim.point.on_b); }))
        touches_.push_back(rim);
    return touches_;
  }

 private:
  // What is nearest to an edge may come down on the face before the step is over: a plank that tips over a seam.
  void look_at_face(const pairs::Convex& triangle, Vec3 flat, int part, int index) {
    const pairs::Placed convex(convex_, at_), placed(triangle, mesh_);
    const Vec3 normal = dot(flat, pairs::middle(convex) - placed.world(triangle.corners[0])) < 0 ? -flat : flat;
    pairs::Manifold below;
    if (!pairs::clip(convex_, at_, triangle, mesh_, normal, margin_, below)) return;
    for (int i = 0; i < below.count; ++i)
      if (below.points[i].separation > -kSunk * pairs::size_of(convex_)) touches_.push_back({below.points[i], normal, part, index});
  }
  bool holds(const pairs::Convex& triangle, Vec3 point) const {
    const Vec3 p = inverse(mesh_) * point, *c = triangle.corners, flat = normalized(cross(c[1] - c[0], c[2] - c[0]));
    if (std::abs(dot(flat, p - c[0])) > kOnTriangle) return false;
    for (int i = 0; i < 3; ++i)
      if (dot(cross(flat, normalized(c[(i + 1) % 3] - c[i])), p - c[i]) < -kOnTriangle) return false;
    return true;
  }

  const pairs::Convex& convex_;
  Pose at_, mesh_;
  double margin_;
  btVector3 low_, high_;
  std::vector<pairs::Convex> faces_;  // triangles met by their face
  std::vector<Touch> touches_, rims_;
};

bool is_deeper(const Touch& s, const Touch& t) { return s.point.separation < t.point.separation; }

// Takes those that look the way of the deepest out of the list and chooses up to four; they may come from any triangle.
int take_alike(std::vector<Touch>& touches, Touch* chosen) {
  const Vec3 normal = std::min_element(touches.begin(), touches.end(), is_deeper)->normal;
  const auto differs = [&](const Touch& touch) { return dot(touch.normal, normal) < kAlike; };
  const auto alike = std::stable_partition(touches.begin(), touches.end(), differs);
  pairs::Candidates candidates;
  pairs::Manifold best;
  for (auto touch = alike; touch != touches.end(); ++touch) {
    pairs::Point point = touch->point;
    point.feature = static_cast<std::uint32_t>(touch - touches.begin());  // to find it again
    candidates.add(point);
    if (candidates.count < pairs::Candidates::kMost && touch + 1 != touches.end()) continue;
    pairs::choose_four(candidates, normal, best);
    candidates.count = 0;
    for (int i = 0; i < best.count; ++i) candidates.add(best.points[i]);
  }
  for (int i = 0; i < best.count; ++i) chosen[i] = touches[best.points[i].feature];
  touches.erase(alike, touches.end());
  return best.count;
}

}  // namespace

bool is_mesh(int proxy_type) {
  return proxy_type == TRIANGLE_MESH_SHAPE_PROXYTYPE || proxy_type == SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE ||
         proxy_type == TERRAIN_SHAPE_PROXYTYPE;
}

MeshPair::MeshPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                   bool first)
    : btActivatingCollisionAlgorithm(info, a, b), first_(first) {}

MeshPair::~MeshPair() {
  for (btPersistentManifold* manifold : manifolds_)
    if (manifold) m_dispatcher->releaseManifold(manifold);
}

void MeshPair::getAllContactManifolds(btManifoldArray& manifolds) {
  for (btPersistentManifold* manifold : manifolds_)
    if (manifold) manifolds.push_back(manifold);
}

void MeshPair::write(std::vector<Touch>& touches, const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh,
                     double margin) {
  OldPoints old;
  for (int i = 0; i < used_; ++i) old.add(*manifolds_[i]);
  const int before = used_;
  for (used_ = 0; used_ < kMostManifolds && !touches.empty(); ++used_) {
    Touch chosen[4];
    const int count = take_alike(touches, chosen);
    btPersistentManifold*& manifold = manifolds_[used_];
    if (!manifold) manifold = m_dispatcher->getNewManifold(convex.getCollisionObject(), mesh.getCollisionObject());
    write_points(chosen, count, convex, mesh, margin, old, *manifold);
  }
  for (int i = used_; i < before; ++i) manifolds_[i]->setNumContacts(0);
}

void MeshPair::processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo&,
                                btManifoldResult* result) {
  const btCollisionObjectWrapper &convex = first_ ? *b : *a, &mesh = first_ ? *a : *b;
  pairs::Convex shape;
  if (!convex_of(*convex.getCollisionShape(), shape)) return;
  const double margin = result->m_closestPointDistanceThreshold > 0 ? result->m_closestPointDistanceThreshold : gContactBreakingThreshold;
  btVector3 low, high;
  convex.getCollisionShape()->getAabb(mesh.getWorldTransform().inverseTimes(convex.getWorldTransform()), low, high);
  const btVector3 grow(margin, margin, margin);
  low -= grow;
  high += grow;
  Collector found(shape, from_bullet(convex.getWorldTransform()), from_bullet(mesh.getWorldTransform()), margin, low, high);
  static_cast<const btConcaveShape*>(mesh.getCollisionShape())->processAllTriangles(&found, low, high);
  write(found.touches(), convex, mesh, margin);
}

btCollisionAlgorithm* MeshPair::CreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                     const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) {
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(MeshPair))) MeshPair(info, a, b, first);
}

}  // namespace tumble
