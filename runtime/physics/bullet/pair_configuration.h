// Bullet's collision configuration with our algorithms for convex shapes, compounds and meshes; what else there is, and all
// queries but those of two convex shapes, as Bullet has it.
#pragma once

#include "physics/bullet/compound_pair.h"
#include "physics/bullet/convex_pair.h"
#include "physics/bullet/mesh_pair.h"

namespace tumble {

class PairConfiguration final : public btDefaultCollisionConfiguration {
 public:
  PairConfiguration();
  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override;
  btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int type_a, int type_b) override;

 private:
  ConvexPair::CreateFunc contacts_{ConvexPair::Use::contacts}, closest_points_{ConvexPair::Use::closest_points};
  CompoundPair::CreateFunc first_{false}, second_{true};
  MeshPair::CreateFunc mesh_first_{true}, mesh_second_{false};
};

}  // namespace tumble
