#include "physics/bullet/pair_configuration.h"

#include <algorithm>

namespace tumble {

namespace {

// Bullet's pool has elements of one size, and only its own algorithms are counted unless it is told.
btDefaultCollisionConstructionInfo with_room() {
  btDefaultCollisionConstructionInfo info;
  const std::size_t most = std::max({sizeof(ConvexPair), sizeof(CompoundPair), sizeof(MeshPair)});
  info.m_customCollisionAlgorithmMaxElementSize = static_cast<int>(most);
  return info;
}

bool both_served(int type_a, int type_b) { return is_served(type_a) && is_served(type_b); }

}  // namespace

PairConfiguration::PairConfiguration() : btDefaultCollisionConfiguration(with_room()) {}

btCollisionAlgorithmCreateFunc* PairConfiguration::getCollisionAlgorithmCreateFunc(int type_a, int type_b) {
  if (both_served(type_a, type_b)) return &contacts_;
  if (is_mesh(type_a) && is_served(type_b)) return &mesh_first_;
  if (is_served(type_a) && is_mesh(type_b)) return &mesh_second_;
  if (btBroadphaseProxy::isCompound(type_a)) return &first_;
  if (btBroadphaseProxy::isCompound(type_b)) return &second_;
  return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_a, type_b);
}

btCollisionAlgorithmCreateFunc* PairConfiguration::getClosestPointsAlgorithmCreateFunc(int type_a, int type_b) {
  if (both_served(type_a, type_b)) return &closest_points_;
  return btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(type_a, type_b);
}

}  // namespace tumble
