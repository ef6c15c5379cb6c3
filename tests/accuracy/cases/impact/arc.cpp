#include "accuracy/cases/impact/arc.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

// Where a falling function of time goes through zero.
template <class F>
double root(double from, double to, const F& f) {
  for (int i = 0; i < 50; ++i) {
    const double middle = (from + to) / 2;
    (f(middle) > 0 ? from : to) = middle;
  }
  return (from + to) / 2;
}

}  // namespace

double Arc::at(double time) const {
  const double s = time / seconds, way = to.place - from.place, a = from.speed * seconds, b = to.speed * seconds;
  return from.place + s * (a + s * (3 * way - 2 * a - b + s * (a + b - 2 * way)));
}

double Arc::speed_at(double time) const {
  const double s = time / seconds, way = to.place - from.place, a = from.speed * seconds, b = to.speed * seconds;
  return (a + s * (2 * (3 * way - 2 * a - b) + s * 3 * (a + b - 2 * way))) / seconds;
}

double Arc::highest() const {
  const double ends = std::max(from.place, to.place);
  if (from.speed <= 0 || to.speed >= 0) return ends;
  return std::max(ends, at(root(0, seconds, [this](double time) { return speed_at(time); })));
}

double Arc::falls_to(double level) const {
  return root(0, seconds, [this, level](double time) { return at(time) - level; });
}

}  // namespace tumble::accuracy
