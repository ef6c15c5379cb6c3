// A symmetric 3 by 3 matrix: an inertia, or its inverse, in the world.
#pragma once

#include "base/math.h"

namespace tumble::dynamics {

struct Symmetric {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

constexpr Vec3 operator*(const Symmetric& m, Vec3 v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z, m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
constexpr Symmetric operator+(const Symmetric& a, const Symmetric& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

// The matrix that has `diagonal` along axes turned by `rotation`: R diag Rt.
inline Symmetric turned(Quat rotation, Vec3 diagonal) {
  const Vec3 x = rotation * Vec3{1, 0, 0}, y = rotation * Vec3{0, 1, 0}, z = rotation * Vec3{0, 0, 1};
  const auto at = [&](double Vec3::*i, double Vec3::*j) {
    return diagonal.x * (x.*i) * (x.*j) + diagonal.y * (y.*i) * (y.*j) + diagonal.z * (z.*i) * (z.*j);
  };
  return {at(&Vec3::x, &Vec3::x), at(&Vec3::y, &Vec3::y), at(&Vec3::z, &Vec3::z),
          at(&Vec3::x, &Vec3::y), at(&Vec3::x, &Vec3::z), at(&Vec3::y, &Vec3::z)};
}

// The adjugate over the determinant; all 0 where there is no inverse.
constexpr Symmetric inverse(const Symmetric& m) {
  const double xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
  const double determinant = m.xx * xx + m.xy * xy + m.xz * xz;
  if (!(determinant > 0)) return {};
  const double d = 1 / determinant;
  return {xx * d, (m.xx * m.zz - m.xz * m.xz) * d, (m.xx * m.yy - m.xy * m.xy) * d,
          xy * d, xz * d, (m.xy * m.xz - m.xx * m.yz) * d};
}

}  // namespace tumble::dynamics
