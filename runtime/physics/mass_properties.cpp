#include <Eigen/Eigenvalues>

#include "physics/body.h"
#include "physics/solids.h"

namespace tumble {

namespace {

struct Part {
  Solid solid;
  Pose pose;
  double density = 1;
};

bool is_trigger(const BodyDef& body, const ColliderDef& collider) { return collider.trigger.value_or(body.trigger); }

// Triggers have no mass, unless there is nothing else.
std::vector<Part> massive_parts(const BodyDef& body) {
  bool solid = false;
  for (const ColliderDef& collider : body.colliders) solid |= !is_trigger(body, collider);
  std::vector<Part> parts;
  for (const ColliderDef& collider : body.colliders) {
    if (solid && is_trigger(body, collider)) continue;
    const double density = collider.density.value_or(body.density.value_or(1));
    parts.push_back({solid_of(collider.shape), {collider.offset, normalized(collider.rotation)}, density});
  }
  return parts;
}

// The given mass; else by the densities, where all that has mass has one; else 1 kg.
double mass_of(const BodyDef& body, const std::vector<Part>& parts, double sum) {
  if (body.mass) return *body.mass;
  bool dense = body.density.has_value() || !parts.empty();
  if (!body.density)
    for (const ColliderDef& collider : body.colliders) dense &= collider.density.has_value() || is_trigger(body, collider);
  return dense && sum > 0 ? sum : 1;
}

Eigen::Matrix3d matrix(Quat q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix(); }
Eigen::Vector3d vector(Vec3 v) { return {v.x, v.y, v.z}; }

// Steiner: inertia about a point at distance d from the centre.
Eigen::Matrix3d shifted(double mass, const Eigen::Vector3d& d) {
  return mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
}

void set_principal(MassProperties& result, const Eigen::Matrix3d& tensor) {
  const double off = std::abs(tensor(0, 1)) + std::abs(tensor(0, 2)) + std::abs(tensor(1, 2));
  if (off < 1e-12 * tensor.trace()) {  // already principal: keep the body's axes, also where moments are equal
    result.inertia = {tensor(0, 0), tensor(1, 1), tensor(2, 2)};
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Eigen::Quaterniond q(axes);
  result.axes = normalized(Quat{q.x(), q.y(), q.z(), q.w()});
  result.inertia = {solver.eigenvalues()[0], solver.eigenvalues()[1], solver.eigenvalues()[2]};
}

MassProperties by_colliders(const BodyDef& body) {
  const std::vector<Part> parts = massive_parts(body);
  double sum = 0;
  Vec3 center;
  for (const Part& part : parts) {
    sum += part.solid.volume * part.density;
    center += part.pose * part.solid.center * (part.solid.volume * part.density);
  }

  MassProperties result;
  result.mass = mass_of(body, parts, sum);
  if (sum <= 0) {  // nothing has a volume: turns as a ball of 1 m across
    const double i = 0.1 * result.mass;
    result.inertia = {i, i, i};
    result.center = body.center_of_mass.value_or(Vec3{});
    return result;
  }
  result.center = body.center_of_mass.value_or(center / sum);

  const double scale = result.mass / sum;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const Part& part : parts) {
    Eigen::Matrix3d own;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) own(i, j) = part.solid.inertia[i][j];
    const Eigen::Matrix3d turn = matrix(part.pose.rotation);
    tensor += scale * part.density * (turn * own * turn.transpose());
    tensor += shifted(scale * part.density * part.solid.volume, vector(part.pose * part.solid.center - result.center));
  }
  set_principal(result, tensor);
  return result;
}

}  // namespace

MassProperties mass_properties(const BodyDef& body) {
  if (body.type != BodyType::dynamic) return {};
  MassProperties result = by_colliders(body);
  if (!body.inertia) return result;
  result.inertia = *body.inertia;
  result.axes = {};
  return result;
}

}  // namespace tumble
