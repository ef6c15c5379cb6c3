#include "accuracy/cases/motion/moments.h"

namespace tumble::accuracy {

namespace {

// The sum of both over all nine places, the second one times a factor.
Matrix plus(Matrix a, const Matrix& b, double factor = 1) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) a[i][j] += b[i][j] * factor;
  return a;
}

Matrix outer(Vec3 a, Vec3 b) {
  const std::array<double, 3> u{a.x, a.y, a.z}, v{b.x, b.y, b.z};
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = u[i] * v[j];
  return out;
}

// A solid whose centre is on y, from its mean squares about that centre along x, y, z.
Moments centered(double volume, Vec3 squares, double y = 0) {
  const Vec3 center{0, y, 0};
  return {volume, center * volume, plus(diagonal(squares * volume), outer(center, center), volume)};
}

}  // namespace

Matrix diagonal(Vec3 v) { return {{{v.x, 0, 0}, {0, v.y, 0}, {0, 0, v.z}}}; }

Matrix turned(const Matrix& m, Quat rotation) {
  const std::array<Vec3, 3> axes{rotation * Vec3{1, 0, 0}, rotation * Vec3{0, 1, 0}, rotation * Vec3{0, 0, 1}};
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out = plus(out, outer(axes[i], axes[j]), m[i][j]);
  return out;
}

double norm(const Matrix& m) {
  double sum = 0;
  for (const auto& row : m)
    for (const double x : row) sum += x * x;
  return std::sqrt(sum);
}

double distance(const Matrix& a, const Matrix& b) { return norm(plus(a, b, -1)); }

Matrix Moments::inertia() const {
  const Matrix spread = plus(second, outer(center(), center()), -mass);
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  return plus(diagonal({trace, trace, trace}), spread, -1);
}

Moments operator+(const Moments& a, const Moments& b) { return {a.mass + b.mass, a.first + b.first, plus(a.second, b.second)}; }
Moments operator*(const Moments& a, double density) { return {a.mass * density, a.first * density, plus({}, a.second, density)}; }

Moments placed(const Moments& part, const Pose& pose) {
  const Vec3 t = pose.position, first = pose.rotation * part.first;
  Matrix second = plus(turned(part.second, pose.rotation), outer(t, t), part.mass);
  second = plus(plus(second, outer(t, first)), outer(first, t));
  return {part.mass, first + t * part.mass, second};
}

Moments solid_box(Vec3 size) { return centered(size.x * size.y * size.z, scaled(size, size) / 12); }

Moments solid_ball(double r) { return centered(4 * kPi / 3 * r * r * r, Vec3{1, 1, 1} * (r * r / 5)); }

Moments solid_cylinder(double r, double h) { return centered(kPi * r * r * h, {r * r / 4, h * h / 12, r * r / 4}); }

// Half a ball: its centre is 3/8 r above its flat side, of which y^2 has the mean r^2 / 5.
Moments solid_capsule(double r, double height) {
  const double middle = height - 2 * r, half_ball = 2 * kPi / 3 * r * r * r;
  const Moments cap = centered(half_ball, {r * r / 5, r * r * (1.0 / 5 - 9.0 / 64), r * r / 5}, r * 3 / 8);
  const Pose up{{0, middle / 2, 0}, {}}, down{{0, -middle / 2, 0}, {1, 0, 0, 0}};
  return solid_cylinder(r, middle) + placed(cap, up) + placed(cap, down);
}

Moments solid_cone(double r, double h) { return centered(kPi * r * r * h / 3, {r * r * 3 / 20, h * h * 3 / 80, r * r * 3 / 20}, -h / 4); }

Moments solid_pyramid(Vec3 size) {
  return centered(size.x * size.y * size.z / 3, {size.x * size.x / 20, size.y * size.y * 3 / 80, size.z * size.z / 20}, -size.y / 4);
}

Moments solid_torus(double radius, double thickness) {
  const double r = thickness / 2, across = (radius * radius + 0.75 * r * r) / 2;
  return centered(2 * kPi * kPi * radius * r * r, {across, r * r / 4, across});
}

Moments solid_tetrahedron(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const double volume = std::abs(dot(b - a, cross(c - a, d - a))) / 6;
  const Vec3 sum = a + b + c + d;
  Matrix second = outer(sum, sum);
  for (const Vec3 corner : {a, b, c, d}) second = plus(second, outer(corner, corner));
  return {volume, sum * (volume / 4), plus({}, second, volume / 20)};
}

}  // namespace tumble::accuracy
