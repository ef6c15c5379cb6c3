#include "physics/pairs/hub.h"

#include <algorithm>

namespace tumble::pairs {

Hub hub_of(const Convex& shape, const Pose& at, Vec3 center, Vec3 arm) {
  const Vec3 middle = at.position - center, axis = at.rotation * Vec3{0, 1, 0};
  switch (shape.kind) {
    case Convex::sphere: return {middle, false, {}};
    case Convex::capsule: return {middle + axis * std::clamp(dot(axis, arm - middle), -shape.half_height, shape.half_height), false, {}};
    case Convex::cylinder:
    case Convex::cone: return {middle + axis * dot(axis, arm - middle), false, axis};
    default: return {arm, true, {}};
  }
}

}  // namespace tumble::pairs
