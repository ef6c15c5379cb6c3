#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

Vec3 on_floor(double azimuth) { return {std::cos(azimuth), 0, std::sin(azimuth)}; }

Vec3 on_slope(double slope, double azimuth) { return (on_floor(azimuth) * std::sin(slope) - Vec3{0, std::cos(slope), 0}) * kGravity; }

double yaw(const Simulation& scene, BodyIndex body) {
  const Vec3 x = scene.pose(body).rotation * Vec3{1, 0, 0};
  return std::atan2(-x.z, x.x);
}

double threshold(double low, double high, int halvings, const std::function<bool(double)>& holds) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (holds(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace tumble::accuracy
