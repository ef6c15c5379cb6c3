#include "accuracy/cases/impact/overlap.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace tumble::accuracy {

namespace {

std::array<Vec3, 3> axes(const Pose& pose) { return {pose.rotation * Vec3{1, 0, 0}, pose.rotation * Vec3{0, 1, 0}, pose.rotation * Vec3{0, 0, 1}}; }

// Half of the shadow that a box throws on an axis.
double reach(const std::array<Vec3, 3>& axes, Vec3 edges, Vec3 along) {
  return (std::abs(dot(axes[0], along)) * edges.x + std::abs(dot(axes[1], along)) * edges.y + std::abs(dot(axes[2], along)) * edges.z) / 2;
}

}  // namespace

double box_overlap(const Pose& a, Vec3 edges_a, const Pose& b, Vec3 edges_b) {
  const std::array<Vec3, 3> of_a = axes(a), of_b = axes(b);
  std::vector<Vec3> candidates(of_a.begin(), of_a.end());
  candidates.insert(candidates.end(), of_b.begin(), of_b.end());
  for (const Vec3& u : of_a)
    for (const Vec3& v : of_b)
      if (length(cross(u, v)) > 1e-6) candidates.push_back(normalized(cross(u, v)));
  double least = INFINITY;
  for (const Vec3& axis : candidates)
    least = std::min(least, reach(of_a, edges_a, axis) + reach(of_b, edges_b, axis) - std::abs(dot(b.position - a.position, axis)));
  return least;
}

void each_near_pair(const std::vector<Vec3>& points, double within, const std::function<void(std::size_t, std::size_t)>& f) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return points[i].x < points[k].x; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && points[order[k]].x - points[order[i]].x < within; ++k) f(std::min(order[i], order[k]), std::max(order[i], order[k]));
}

}  // namespace tumble::accuracy
