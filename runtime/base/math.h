// Vectors, rotations and poses in double precision, as plain values.
//
// Vec3 and Quat are the public header's structs; this adds their algebra. Matrices and decompositions are Eigen's and
// are used where they are needed, not here. Angles are radians, unless a name says degrees.
#pragma once

#include <cmath>
#include <numbers>

#include "tumble/tumble.h"

namespace tumble {

constexpr double kPi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
constexpr Vec3& operator-=(Vec3& a, Vec3 b) { return a = a - b; }
constexpr bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// Per component.
constexpr Vec3 scaled(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vec3 unscaled(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec3 a, Vec3 b) { return length(a - b); }
constexpr Vec3 lerp(Vec3 a, Vec3 b, double t) { return a + (b - a) * t; }
// The zero vector stays zero.
inline Vec3 normalized(Vec3 a) {
  const double l = length(a);
  return l > 0 ? a / l : Vec3{};
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

constexpr bool operator==(Quat a, Quat b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; }
constexpr Quat operator*(Quat a, Quat b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
// v turned by q, for a unit q: v + 2 u x (u x v + w v).
constexpr Vec3 operator*(Quat q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = cross(u, v) * 2.0;
  return v + t * q.w + cross(u, t);
}
constexpr Quat conjugate(Quat q) { return {-q.x, -q.y, -q.z, q.w}; }
constexpr double dot(Quat a, Quat b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
inline double length(Quat q) { return std::sqrt(dot(q, q)); }
// A quaternion too short to have a direction becomes the identity.
inline Quat normalized(Quat q) {
  const double l = length(q);
  return l > 1e-12 ? Quat{q.x / l, q.y / l, q.z / l, q.w / l} : Quat{};
}
inline bool is_finite(Quat q) { return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w); }

// Rotation about an axis of any length but zero.
inline Quat axis_angle(Vec3 axis, double angle) {
  const Vec3 n = normalized(axis) * std::sin(angle / 2);
  return {n.x, n.y, n.z, std::cos(angle / 2)};
}
Quat slerp(Quat a, Quat b, double t);
// Turns first about y, then about the turned x, then about the turned z (radians): R = Ry Rx Rz.
Quat from_euler(Vec3 angles);
// The inverse of from_euler; x within +-pi/2, and z = 0 where x is at +-pi/2 and z is not determined.
Vec3 to_euler(Quat q);
// The rotation that takes -z to forward and y as near to up as it can; a forward of zero gives the identity.
Quat look_rotation(Vec3 forward, Vec3 up = {0, 1, 0});
// The smallest rotation that takes direction a to direction b.
Quat between(Vec3 a, Vec3 b);

// Where a thing is and how it is turned.
struct Pose {
  Vec3 position;
  Quat rotation;
};
constexpr bool operator==(const Pose& a, const Pose& b) { return a.position == b.position && a.rotation == b.rotation; }
constexpr Vec3 operator*(const Pose& pose, Vec3 local) { return pose.position + pose.rotation * local; }
constexpr Pose operator*(const Pose& a, const Pose& b) { return {a * b.position, a.rotation * b.rotation}; }
constexpr Pose inverse(const Pose& pose) {
  const Quat back = conjugate(pose.rotation);
  return {back * -pose.position, back};
}

}  // namespace tumble
