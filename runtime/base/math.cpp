#include "base/math.h"

#include <algorithm>

namespace tumble {

Quat slerp(Quat a, Quat b, double t) {
  double cosine = dot(a, b);
  if (cosine < 0) {  // the short way round
    b = {-b.x, -b.y, -b.z, -b.w};
    cosine = -cosine;
  }
  // Nearly equal rotations: sin(angle) would be a division by almost zero, and a straight line is exact enough.
  double from = 1 - t, to = t;
  if (cosine < 0.9999) {
    const double angle = std::acos(cosine);
    from = std::sin((1 - t) * angle) / std::sin(angle);
    to = std::sin(t * angle) / std::sin(angle);
  }
  return normalized(Quat{a.x * from + b.x * to, a.y * from + b.y * to, a.z * from + b.z * to, a.w * from + b.w * to});
}

Quat from_euler(Vec3 angles) {
  return axis_angle({0, 1, 0}, angles.y) * axis_angle({1, 0, 0}, angles.x) * axis_angle({0, 0, 1}, angles.z);
}

Vec3 to_euler(Quat q) {
  // Entries of R = Ry Rx Rz: R12 = -sin x, R02/R22 = tan y, R10/R11 = tan z.
  const double sin_x = std::clamp(-2 * (q.y * q.z - q.w * q.x), -1.0, 1.0);
  if (std::abs(sin_x) > 1 - 1e-12)
    return {std::copysign(kPi / 2, sin_x), std::atan2(-2 * (q.x * q.z - q.w * q.y), 1 - 2 * (q.y * q.y + q.z * q.z)), 0};
  return {std::asin(sin_x), std::atan2(2 * (q.x * q.z + q.w * q.y), 1 - 2 * (q.x * q.x + q.y * q.y)),
          std::atan2(2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z))};
}

Quat between(Vec3 a, Vec3 b) {
  a = normalized(a);
  b = normalized(b);
  const double cosine = dot(a, b);
  if (cosine < -1 + 1e-12) {  // opposite: any axis across a will do
    const Vec3 across = std::abs(a.x) < 0.9 ? cross(a, {1, 0, 0}) : cross(a, {0, 1, 0});
    return axis_angle(across, kPi);
  }
  const Vec3 c = cross(a, b);
  return normalized(Quat{c.x, c.y, c.z, 1 + cosine});
}

Quat look_rotation(Vec3 forward, Vec3 up) {
  const Vec3 back = normalized(-forward);
  if (back == Vec3{}) return {};
  Vec3 right = cross(up, back);
  // Looking along up: take the world's x, or where that is parallel too, the world's z, as a stand-in for up.
  if (dot(right, right) < 1e-18) right = cross(std::abs(back.y) > 0.9 ? Vec3{0, 0, back.y > 0 ? -1.0 : 1.0} : Vec3{0, 1, 0}, back);
  right = normalized(right);
  const Vec3 top = cross(back, right);
  // Columns right, top, back to a quaternion, by the largest of the four squares (Shepperd 1978).
  const double trace = right.x + top.y + back.z;
  Quat q;
  if (trace > 0)
    q = {top.z - back.y, back.x - right.z, right.y - top.x, 1 + trace};
  else if (right.x > top.y && right.x > back.z)
    q = {1 + right.x - top.y - back.z, top.x + right.y, back.x + right.z, top.z - back.y};
  else if (top.y > back.z)
    q = {top.x + right.y, 1 + top.y - right.x - back.z, back.y + top.z, back.x - right.z};
  else
    q = {back.x + right.z, back.y + top.z, 1 + back.z - right.x - top.y, right.y - top.x};
  return normalized(q);
}

}  // namespace tumble
