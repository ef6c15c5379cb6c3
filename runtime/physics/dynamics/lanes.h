// Four numbers at a time, on any processor that has such registers (SSE2, NEON, WebAssembly), and one at a time with the
// same code: float and Four are alike to a template. Comparisons select with ?: lane by lane.
#pragma once

#include <cmath>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace tumble::dynamics {

using Four = float __attribute__((vector_size(16)));

template <class F>
constexpr int kLanes = sizeof(F) / sizeof(float);

template <class F>
F all(float value) {
  return F{} + value;
}
template <class F>
F larger(F a, F b) {
  return a > b ? a : b;
}
inline float& lane(float& f, int) { return f; }
inline float lane(const float& f, int) { return f; }
inline auto lane(Four& f, int i) -> decltype(f[0]) { return f[i]; }
inline float lane(const Four& f, int i) { return f[i]; }

inline float root(float f) { return std::sqrt(f); }
#ifdef __SSE__
inline Four root(Four f) { return _mm_sqrt_ps(f); }
#else
inline Four root(Four f) { return {std::sqrt(f[0]), std::sqrt(f[1]), std::sqrt(f[2]), std::sqrt(f[3])}; }
#endif

inline bool any_reaches(float f, float value) { return f >= value; }
#ifdef __SSE__
inline bool any_reaches(Four f, float value) { return _mm_movemask_ps(_mm_cmpge_ps(f, all<Four>(value))) != 0; }
#else
inline bool any_reaches(Four f, float value) { return f[0] >= value || f[1] >= value || f[2] >= value || f[3] >= value; }
#endif

template <class F>
struct Triple {
  F x{}, y{}, z{};
};
template <class F>
F dot(const Triple<F>& a, const Triple<F>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class F>
void add(Triple<F>& sum, const Triple<F>& a, F times) {
  sum.x += a.x * times;
  sum.y += a.y * times;
  sum.z += a.z * times;
}
template <class F>
void set_lane(Triple<F>& to, int i, double x, double y, double z) {
  lane(to.x, i) = static_cast<float>(x);
  lane(to.y, i) = static_cast<float>(y);
  lane(to.z, i) = static_cast<float>(z);
}

// The linear and the angular motion of a body.
struct alignas(16) Motion {
  float along[4] = {}, about[4] = {};
};
template <class F>
struct Motions {
  Triple<F> along, about;
};

inline void load(const Motion* all, const int* at, Motions<float>& out) {
  const Motion& m = all[at[0]];
  out = {{m.along[0], m.along[1], m.along[2]}, {m.about[0], m.about[1], m.about[2]}};
}
// Not of number 0, which is all that cannot be pushed: other threads read it.
inline void store(Motion* all, const int* at, const Motions<float>& m) {
  if (at[0]) all[at[0]] = {{m.along.x, m.along.y, m.along.z, 0}, {m.about.x, m.about.y, m.about.z, 0}};
}

inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5), ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5), cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}
inline const Four& four(const float* from) { return *reinterpret_cast<const Four*>(from); }
inline Four& four(float* from) { return *reinterpret_cast<Four*>(from); }

inline void load(const Motion* all, const int* at, Motions<Four>& out) {
  Four a = four(all[at[0]].along), b = four(all[at[1]].along), c = four(all[at[2]].along), d = four(all[at[3]].along);
  transpose(a, b, c, d);
  out.along = {a, b, c};
  a = four(all[at[0]].about), b = four(all[at[1]].about), c = four(all[at[2]].about), d = four(all[at[3]].about);
  transpose(a, b, c, d);
  out.about = {a, b, c};
}
inline void store(Motion* all, const int* at, const Motions<Four>& m) {
  Four along[4] = {m.along.x, m.along.y, m.along.z, {}}, about[4] = {m.about.x, m.about.y, m.about.z, {}};
  transpose(along[0], along[1], along[2], along[3]);
  transpose(about[0], about[1], about[2], about[3]);
  for (int i = 0; i < 4; ++i) {
    if (!at[i]) continue;
    four(all[at[i]].along) = along[i];
    four(all[at[i]].about) = about[i];
  }
}

}  // namespace tumble::dynamics
