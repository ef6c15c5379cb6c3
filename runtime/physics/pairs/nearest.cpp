#include "physics/pairs/nearest.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

constexpr int kMostRounds = 96;
// Of the size: cores nearer than this touch, and their difference is too short to be a direction.
constexpr double kTouch = 1e-8;
// Of the squared distance: a point that comes no nearer by more ends the search.
constexpr double kProgress = 1e-14;

void keep(Simplex& simplex, std::initializer_list<int> chosen, std::initializer_list<double> weights) {
  const Simplex old = simplex;
  simplex.count = 0;
  auto weight = weights.begin();
  for (const int i : chosen) {
    simplex.points[simplex.count] = old.points[i];
    simplex.weights[simplex.count++] = *weight++;
  }
}

Vec3 mixed(const Simplex& simplex, Vec3 Difference::* part) {
  Vec3 sum;
  for (int i = 0; i < simplex.count; ++i) sum += simplex.points[i].*part * simplex.weights[i];
  return sum;
}

void reduce_segment(Simplex& s, int i, int j) {
  const Vec3 a = s.points[i].at, ab = s.points[j].at - a;
  const double size2 = dot(ab, ab), t = size2 > 0 ? -dot(a, ab) / size2 : 0;
  if (t <= 0) keep(s, {i}, {1});
  else if (t >= 1) keep(s, {j}, {1});
  else keep(s, {i, j}, {1 - t, t});
}

// By the regions around a triangle (C. Ericson, Real-Time Collision Detection, 5.1.5), for the origin.
void reduce_triangle(Simplex& s, int i, int j, int k) {
  const Vec3 a = s.points[i].at, b = s.points[j].at, c = s.points[k].at, ab = b - a, ac = c - a;
  const double d1 = -dot(ab, a), d2 = -dot(ac, a), d3 = -dot(ab, b), d4 = -dot(ac, b), d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d1 <= 0 && d2 <= 0) return keep(s, {i}, {1});
  if (d3 >= 0 && d4 <= d3) return keep(s, {j}, {1});
  if (d6 >= 0 && d5 <= d6) return keep(s, {k}, {1});
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return reduce_segment(s, i, j);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return reduce_segment(s, i, k);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return reduce_segment(s, j, k);
  const double sum = va + vb + vc;
  keep(s, {i, j, k}, {va / sum, vb / sum, vc / sum});
}

// Is the origin beyond the plane of three points, seen from the fourth? Yes too where the four are flat.
bool beyond(const Simplex& s, int i, int j, int k, int fourth) {
  const Vec3 a = s.points[i].at, ab = s.points[j].at - a, ac = s.points[k].at - a, ad = s.points[fourth].at - a;
  const Vec3 normal = cross(ab, ac);
  const double inside = dot(ad, normal), flat = 1e-10 * length(normal) * length(ad);
  return std::abs(inside) <= flat || -dot(a, normal) * inside < 0;
}

// False if the origin lies within.
bool reduce_tetrahedron(Simplex& s) {
  constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  Simplex best;
  double least = 1e300;
  for (const auto& f : kFaces) {
    if (!beyond(s, f[0], f[1], f[2], f[3])) continue;
    Simplex face = s;
    reduce_triangle(face, f[0], f[1], f[2]);
    const Vec3 at = mixed(face, &Difference::at);
    if (dot(at, at) < least) least = dot(at, at), best = face;
  }
  if (least == 1e300) return false;
  s = best;
  return true;
}

// Leaves the points around the one nearest to the origin; false if the origin lies within all four.
bool reduce(Simplex& s) {
  switch (s.count) {
    case 1: s.weights[0] = 1; return true;
    case 2: reduce_segment(s, 0, 1); return true;
    case 3: reduce_triangle(s, 0, 1, 2); return true;
    default: return reduce_tetrahedron(s);
  }
}

bool has(const Simplex& s, Vec3 at) {
  return std::any_of(s.points, s.points + s.count, [&](const Difference& p) { return p.at == at; });
}

enum class Cores { apart, far, touch };

Cores search(const Placed& a, const Placed& b, double reach, Vec3 start, Simplex& simplex) {
  const double touch = kTouch * (size_of(a.shape) + size_of(b.shape));
  simplex.points[0] = difference(a, b, -start);
  simplex.count = 1;
  simplex.weights[0] = 1;
  Vec3 v = simplex.points[0].at;
  double vv = dot(v, v);
  for (int round = 0; round < kMostRounds; ++round) {
    if (vv <= touch * touch) return Cores::touch;
    const Difference next = difference(a, b, -v);
    const double along = dot(v, next.at);
    if (along > 0 && along * along > reach * reach * vv) return Cores::far;
    if (vv - along <= kProgress * vv || has(simplex, next.at)) break;
    Simplex grown = simplex;
    grown.points[grown.count++] = next;
    if (!reduce(grown)) {
      simplex = grown;
      return Cores::touch;
    }
    const Vec3 at = mixed(grown, &Difference::at);
    if (dot(at, at) >= vv) break;  // no nearer: rounding
    simplex = grown;
    v = at;
    vv = dot(v, v);
  }
  return Cores::apart;
}

}  // namespace

Difference difference(const Placed& a, const Placed& b, Vec3 direction) {
  const Vec3 on_a = furthest_of_core(a, direction), on_b = furthest_of_core(b, -direction);
  return {on_a - on_b, on_a, on_b};
}

bool nearest(const Placed& a, const Placed& b, double margin, Vec3 start, Nearest& out) {
  if (start == Vec3{}) start = middle(a) - middle(b);
  if (start == Vec3{}) start = {0, 1, 0};
  const double round_a = rounding(a.shape), round_b = rounding(b.shape);
  Simplex simplex;
  const Cores cores = search(a, b, margin + round_a + round_b, start, simplex);
  if (cores == Cores::far) return false;
  if (cores == Cores::touch) {
    if (!penetration(a, b, simplex, out)) return false;
  } else {
    const Vec3 v = mixed(simplex, &Difference::at);
    out.separation = length(v);
    out.normal = v / out.separation;
    out.on_a = mixed(simplex, &Difference::on_a);
    out.on_b = mixed(simplex, &Difference::on_b);
  }
  out.on_a += out.normal * -round_a;
  out.on_b += out.normal * round_b;
  out.separation -= round_a + round_b;
  return out.separation <= margin;
}

}  // namespace tumble::pairs
