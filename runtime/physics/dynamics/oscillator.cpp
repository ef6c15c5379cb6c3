#include "physics/dynamics/oscillator.h"

#include <cmath>

namespace tumble::dynamics {

Swing swung(Swing from, double w, double z, double seconds) {
  const double x = from.position, v = from.velocity, t = seconds, d = 1 - z * z;
  // x(t) = e^(-z w t) (x C + (v + z w x) S), v(t) = e^(-z w t) (v C - (z w v + w^2 x) S).
  double c, s;  // already with the exponential, which alone may be too small and the cosh too large
  if (std::abs(d) < 1e-8) {
    c = std::exp(-z * w * t);
    s = t * c;
  } else if (d > 0) {
    const double wd = w * std::sqrt(d), kept = std::exp(-z * w * t);
    c = kept * std::cos(wd * t);
    s = kept * std::sin(wd * t) / wd;
  } else {
    const double k = w * std::sqrt(-d), slow = std::exp((k - z * w) * t), fast = std::exp(-(k + z * w) * t);
    c = (slow + fast) / 2;
    s = (slow - fast) / (2 * k);
  }
  return {x * c + (v + z * w * x) * s, v * c - (z * w * v + w * w * x) * s};
}

}  // namespace tumble::dynamics
