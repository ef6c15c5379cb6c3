// Mass, centre and inertia of every collider. They are under everything that turns: where they are off, no step size
// mends a spin, a roll or a pendulum.
#include <algorithm>

#include "accuracy/cases/motion/moments.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

BodyDef weighed(BodyDef body, const Moments& truth) {
  body.mass = truth.mass;
  return body;
}

ColliderDef collider(const Shape& shape, Vec3 offset, Quat rotation, double density) {
  ColliderDef out;
  out.shape = shape;
  out.offset = offset;
  out.rotation = rotation;
  out.density = density;
  return out;
}

Outcome compared(Trial& trial, const BodyDef& body, const Moments& truth) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const MassProperties mass = scene.mass_properties(scene.add(body, {}));

  const Matrix inertia = turned(diagonal(mass.inertia), mass.axes), expected = (truth * trial.reference(1)).inertia();
  const double size = std::sqrt(norm(expected) / truth.mass);
  Outcome outcome;
  outcome.error = std::max({relative(mass.mass, trial.reference(truth.mass)), distance(mass.center, truth.center()) / size,
                            distance(inertia, expected) / norm(expected)});
  return outcome;
}

Part single(const std::string& name, const Shape& shape, const Moments& truth) {
  return {name, 1e-6, [=](Trial& t) { return compared(t, weighed(dynamic(shape, 1), truth), truth); }};
}

// Half a block, cut along a diagonal: its centre is not at its frame's origin.
Part wedge() {
  const Vec3 a{0, 0, 0}, b{2, 0, 0}, c{0, 1, 0}, a2{0, 0, 3}, b2{2, 0, 3}, c2{0, 1, 3};
  return single("hull wedge", hull({a, b, c, a2, b2, c2}), solid_tetrahedron(a, b, c, a2) + solid_tetrahedron(b, c, a2, b2) + solid_tetrahedron(c, a2, b2, c2));
}

Part slanted_octahedron() {
  const Vec3 left{-1, 0, 0}, right{1.5, 0.2, 0}, back{0, 0, -0.6}, front{0, 0.1, 0.7}, down{0.2, -0.5, 0}, up{0, 0.9, 0.1};
  Moments sum;
  for (const auto& [p, q] : {std::pair{left, back}, {back, right}, {right, front}, {front, left}}) sum = sum + solid_tetrahedron(down, up, p, q);
  return single("hull of 6 points", hull({left, right, back, front, down, up}), sum);
}

Part small_hull_cube() {
  std::vector<Vec3> corners;
  for (const double x : {-0.05, 0.05})
    for (const double y : {-0.05, 0.05})
      for (const double z : {-0.05, 0.05}) corners.push_back({x, y, z});
  return single("hull cube 0.1 m", hull(corners), solid_box({0.1, 0.1, 0.1}));
}

Outcome turned_ball(Trial& trial) {
  BodyDef body = dynamic(ball(0.5), 1);
  body.colliders.front().rotation = axis_angle({1, 2, 3}, 1);
  return compared(trial, weighed(body, solid_ball(0.5)), solid_ball(0.5));
}

// Three parts of different densities, one of them askew.
BodyDef three_parts(Moments& truth) {
  const Pose on_top{{0.2, 0.9, 0}, {}}, aside{{-0.8, 0.3, 0.4}, axis_angle({1, 1, 0}, 0.7)};
  BodyDef body;
  body.colliders = {collider(box({1, 0.6, 0.8}), {}, {}, 1), collider(ball(0.4), on_top.position, on_top.rotation, 2),
                    collider(upright(ShapeKind::capsule, 0.2, 1), aside.position, aside.rotation, 3)};
  truth = solid_box({1, 0.6, 0.8}) + placed(solid_ball(0.4), on_top) * 2 + placed(solid_capsule(0.2, 1), aside) * 3;
  return body;
}

Outcome compound(Trial& trial) {
  Moments truth;
  const BodyDef body = three_parts(truth);
  return compared(trial, weighed(body, truth), truth);
}

Outcome by_density(Trial& trial) {
  Moments truth;
  const BodyDef body = three_parts(truth);
  return compared(trial, body, truth);
}

Outcome mesh(Trial&) { throw Missing{"dynamic bodies of triangle meshes"}; }

}  // namespace

Case a28_mass_properties() {
  Case c{"A28", "Mass properties", "one body of each collider", "F: moments of solids; hulls as sums of tetrahedra, compounds as sums of their parts",
         "the worst of mass, centre and inertia tensor, each over the true one", {}};
  Shape torus;
  torus.shape = ShapeKind::torus;
  torus.radius = 0.5;
  torus.thickness = 0.2;
  Shape pyramid = box({1, 1.5, 2});
  pyramid.shape = ShapeKind::pyramid;
  Shape plane = box({2, 0, 3});
  plane.shape = ShapeKind::plane;
  c.parts = {single("box", box({1, 2, 3}), solid_box({1, 2, 3})),
             single("sphere", ball(0.5), solid_ball(0.5)),
             single("capsule", upright(ShapeKind::capsule, 0.5, 2), solid_capsule(0.5, 2)),
             single("cylinder", upright(ShapeKind::cylinder, 0.5, 2), solid_cylinder(0.5, 2)),
             single("cone", upright(ShapeKind::cone, 0.5, 2), solid_cone(0.5, 2)),
             single("pyramid", pyramid, solid_pyramid({1, 1.5, 2})),
             single("torus", torus, solid_torus(0.5, 0.2)),
             single("plane", plane, placed(solid_box({2, 0.1, 3}), {{0, -0.05, 0}, {}})),
             small_hull_cube(),
             wedge(),
             slanted_octahedron(),
             {"turned sphere", 1e-6, turned_ball},
             {"compound", 1e-6, compound},
             {"by density", 1e-6, by_density},
             {"mesh", 1e-6, mesh}};
  return c;
}

}  // namespace tumble::accuracy
