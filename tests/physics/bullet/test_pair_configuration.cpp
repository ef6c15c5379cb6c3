#include "physics/bullet/pair_configuration.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <catch2/catch.hpp>

#include <memory>

using namespace tumble;

namespace {

constexpr double kReach = 0.1;  // m: how far apart contacts are wanted

// As a step does it that looks ahead: the result carries a distance threshold.
void look_ahead(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  const auto* a = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
  const auto* b = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
  const btCollisionObjectWrapper wrap_a(nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1, -1);
  const btCollisionObjectWrapper wrap_b(nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1, -1);
  if (!pair.m_algorithm) pair.m_algorithm = dispatcher.findAlgorithm(&wrap_a, &wrap_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  btManifoldResult result(&wrap_a, &wrap_b);
  result.m_closestPointDistanceThreshold = kReach;
  pair.m_algorithm->processCollision(&wrap_a, &wrap_b, info, &result);
}

// A World sets what asks its bodies for their materials, for the whole program; the objects here belong to none.
struct PlainMaterials {
  CalculateCombinedCallback friction = gCalculateCombinedFrictionCallback, restitution = gCalculateCombinedRestitutionCallback;
  PlainMaterials() {
    gCalculateCombinedFrictionCallback = btManifoldResult::calculateCombinedFriction;
    gCalculateCombinedRestitutionCallback = btManifoldResult::calculateCombinedRestitution;
  }
  ~PlainMaterials() {
    gCalculateCombinedFrictionCallback = friction;
    gCalculateCombinedRestitutionCallback = restitution;
  }
};

struct Bench {
  PlainMaterials materials;
  PairConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  std::vector<std::unique_ptr<btCollisionObject>> objects;

  Bench() { dispatcher.setNearCallback(look_ahead); }
  ~Bench() {
    for (auto& object : objects) world.removeCollisionObject(object.get());
  }
  btCollisionObject& add(btCollisionShape& shape, Vec3 place) {
    objects.push_back(std::make_unique<btCollisionObject>());
    btCollisionObject& object = *objects.back();
    object.setCollisionShape(&shape);
    move(object, place);
    world.addCollisionObject(&object);
    return object;
  }
  void move(btCollisionObject& object, Vec3 place) { object.setWorldTransform(btTransform(btQuaternion::getIdentity(), to_bullet(place))); }
  void look() { world.performDiscreteCollisionDetection(); }
  std::vector<btManifoldPoint*> points() {
    std::vector<btManifoldPoint*> all;
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      for (int i = 0; i < manifold.getNumContacts(); ++i) all.push_back(&manifold.getContactPoint(i));
    }
    return all;
  }
  // Of the first manifold: does the normal go from its second body to its first?
  bool normal_is_right(const btCollisionObject& upper) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(0);
    const double up = manifold.getContactPoint(0).m_normalWorldOnB.y();
    return manifold.getBody0() == &upper ? up > 0.99 : up < -0.99;
  }
};

// Two triangles, 4 m wide, at y = 0.
struct Floor {
  std::vector<btVector3> corners{{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}};
  std::vector<int> indices{0, 1, 2, 0, 2, 3};
  btTriangleIndexVertexArray triangles{2, indices.data(), 3 * sizeof(int), 4, &corners[0].m_floats[0], sizeof(btVector3)};
  btBvhTriangleMeshShape shape{&triangles, true};
};

}  // namespace

TEST_CASE("pairs in Bullet: a box on a box has four points that keep their impulses while it moves", "[physics][pairs]") {
  btBoxShape table(btVector3(2, 0.5, 2)), box(btVector3(0.3, 0.2, 0.4));
  for (const bool table_first : {true, false}) {
    Bench bench;
    if (table_first) bench.add(table, {0, -0.5, 0});
    btCollisionObject& moving = bench.add(box, {0, 0.23, 0});
    if (!table_first) bench.add(table, {0, -0.5, 0});

    bench.look();
    REQUIRE(bench.points().size() == 4);
    CHECK(bench.normal_is_right(moving));
    for (btManifoldPoint* point : bench.points()) {
      CHECK(point->getDistance() == Approx(0.03));
      point->m_appliedImpulse = 10 + point->getPositionWorldOnB().x();
      point->m_appliedImpulseLateral1 = 1;
    }

    bench.move(moving, {0.005, 0.201, 0});
    bench.look();
    REQUIRE(bench.points().size() == 4);
    for (const btManifoldPoint* point : bench.points()) {
      CHECK(point->getDistance() == Approx(0.001));
      CHECK(point->m_appliedImpulse == Approx(10 + point->getPositionWorldOnB().x() - 0.005));
      CHECK(point->m_appliedImpulseLateral1 == 1);
    }

    bench.move(moving, {0.005, 0.31, 0});
    bench.look();
    CHECK(bench.points().empty());
  }
}

TEST_CASE("pairs in Bullet: parts of compounds keep their contacts from pass to pass", "[physics][pairs]") {
  btBoxShape table(btVector3(2, 0.5, 2)), leg(btVector3(0.05, 0.4, 0.05));
  btCompoundShape stool, pair_of_tables;
  for (const double x : {-0.5, 0.5}) stool.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), &leg);
  for (const double x : {-3.0, 0.0}) pair_of_tables.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), &table);
  for (btCollisionShape* below : {static_cast<btCollisionShape*>(&table), static_cast<btCollisionShape*>(&pair_of_tables)}) {
    Bench bench;
    bench.add(*below, {0, -0.5, 0});
    btCollisionObject& moving = bench.add(stool, {0, 0.405, 0});
    bench.look();
    REQUIRE(bench.points().size() == 8);
    for (btManifoldPoint* point : bench.points()) point->m_appliedImpulse = 3;

    bench.move(moving, {0, 0.401, 0});
    bench.look();

    REQUIRE(bench.points().size() == 8);
    int second_leg = 0;
    for (const btManifoldPoint* point : bench.points()) {
      CHECK(point->m_appliedImpulse == 3);
      // The stool came second: its part is told as index 1, the second table's as index 0.
      second_leg += point->m_index1 == 1;
      CHECK(point->m_index0 == (below == &table ? -1 : 1));
    }
    CHECK(second_leg == 4);
  }
}

TEST_CASE("pairs in Bullet: a mesh's triangles together give four points with their names", "[physics][pairs]") {
  Floor floor;
  btBoxShape box(btVector3(0.3, 0.2, 0.4));
  btCompoundShape pair_of_boxes;
  for (const double x : {-0.5, 0.5}) pair_of_boxes.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), &box);
  Bench bench;
  bench.add(floor.shape, {});
  btCollisionObject& moving = bench.add(box, {0, 0.205, 0});
  bench.look();
  REQUIRE(bench.points().size() == 4);  // on both sides of the diagonal
  CHECK(bench.normal_is_right(moving));
  bool triangles[2] = {};
  for (btManifoldPoint* point : bench.points()) {
    CHECK(point->getDistance() == Approx(0.005));
    CHECK(std::abs(point->getPositionWorldOnB().x()) == Approx(0.3));
    const bool mesh_first = point->m_partId0 >= 0;
    CHECK((mesh_first ? point->m_partId0 : point->m_partId1) == 0);
    triangles[mesh_first ? point->m_index0 : point->m_index1] = true;
    point->m_appliedImpulse = 2;
  }
  CHECK((triangles[0] && triangles[1]));

  bench.move(moving, {0.004, 0.2, 0});
  bench.look();
  REQUIRE(bench.points().size() == 4);
  for (const btManifoldPoint* point : bench.points()) CHECK(point->m_appliedImpulse == 2);

  moving.setCollisionShape(&pair_of_boxes);
  bench.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(moving.getBroadphaseHandle(), &bench.dispatcher);
  bench.look();
  CHECK(bench.points().size() == 8);
}

TEST_CASE("pairs in Bullet: queries between two objects see the nearest points", "[physics][pairs]") {
  struct Nearest final : btCollisionWorld::ContactResultCallback {
    double distance = 1e300;
    int count = 0;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
                             int) override {
      distance = std::min(distance, point.getDistance());
      ++count;
      return 0;
    }
  };
  Floor floor;
  btBoxShape table(btVector3(2, 0.5, 2)), leg(btVector3(0.05, 0.4, 0.05));
  btSphereShape ball(0.2);
  btCompoundShape stool;
  for (const double x : {-0.5, 0.5}) stool.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), &leg);
  Bench bench;
  btCollisionObject &below = bench.add(table, {0, -0.5, 0}), &above = bench.add(stool, {0, 0.45, 0});
  btCollisionObject &sphere = bench.add(ball, {0, 0.22, 1}), &mesh = bench.add(floor.shape, {});
  const auto ask = [&](btCollisionObject& a, btCollisionObject& b) {
    Nearest found;
    found.m_closestDistanceThreshold = 0.06;
    bench.world.contactPairTest(&a, &b, found);
    return found;
  };

  CHECK(ask(below, sphere).distance == Approx(0.02));
  CHECK(ask(sphere, mesh).distance == Approx(0.02));
  CHECK(ask(above, below).distance == Approx(0.05));
  CHECK(ask(above, mesh).count > 0);
  CHECK(ask(above, sphere).count == 0);
}
