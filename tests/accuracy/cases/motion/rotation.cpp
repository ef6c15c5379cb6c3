#include "accuracy/cases/motion/rotation.h"

namespace tumble::accuracy {

Vec3 turn_between(Quat from, Quat to) {
  Quat turn = normalized(to * conjugate(from));
  if (turn.w < 0) turn = {-turn.x, -turn.y, -turn.z, -turn.w};
  const Vec3 axis{turn.x, turn.y, turn.z};
  const double sine = length(axis);
  return sine > 0 ? axis * (2 * std::atan2(sine, turn.w) / sine) : Vec3{};
}

double within_half_turn(double angle) { return std::remainder(angle, 2 * kPi); }

TurnWatch::TurnWatch(const Simulation& scene, BodyIndex body)
    : scene_(scene), body_(body), rotation_(scene.pose(body).rotation), velocity_(scene.angular_velocity(body)) {}

void TurnWatch::after_step(double seconds) {
  const Quat rotation = scene_.pose(body_).rotation;
  const Vec3 velocity = scene_.angular_velocity(body_), mean = (velocity_ + velocity) / 2;
  const double expected = length(mean) * seconds;
  const double seen = dot(turn_between(rotation_, rotation), normalized(mean));
  turned_ += expected + within_half_turn(seen - expected);
  reported_ += expected;
  rotation_ = rotation;
  velocity_ = velocity;
}

}  // namespace tumble::accuracy
