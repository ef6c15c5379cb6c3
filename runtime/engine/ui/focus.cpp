#include "engine/ui/focus.h"

#include <algorithm>
#include <limits>

namespace tumble {

namespace {

// A rectangle as the direction sees it: how far ahead its middle is, half its length that way, and how it lies across.
struct Seen {
  double ahead, half, low, high;
};

Seen seen(const UiRect& r, UiDirection direction) {
  const double x = r.x + r.width / 2, y = r.y + r.height / 2;
  switch (direction) {
    case UiDirection::left: return {-x, r.width / 2, r.y, r.bottom()};
    case UiDirection::right: return {x, r.width / 2, r.y, r.bottom()};
    case UiDirection::up: return {-y, r.height / 2, r.x, r.right()};
    case UiDirection::down: return {y, r.height / 2, r.x, r.right()};
  }
  return {};
}

// Between two spans across; 0 where they overlap.
double gap(const Seen& a, const Seen& b) { return std::max({0.0, a.low - b.high, b.low - a.high}); }

}  // namespace

int next_in_direction(const UiRect& from, const std::vector<UiRect>& others, UiDirection direction, bool wrap) {
  constexpr double kAside = 3;         // a unit aside counts as so many ahead
  const Seen here = seen(from, direction);
  // What begins before we end is beside us, not ahead.
  int best = -1, farthest = -1;
  double least = std::numeric_limits<double>::infinity(), most = here.half;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const Seen there = seen(others[i], direction);
    const double ahead = there.ahead - here.ahead, aside = gap(here, there);
    if (ahead > here.half && ahead + kAside * aside < least) {
      least = ahead + kAside * aside;
      best = static_cast<int>(i);
    }
    if (aside == 0 && -ahead > most) {
      most = -ahead;
      farthest = static_cast<int>(i);
    }
  }
  return best >= 0 || !wrap ? best : farthest;
}

}  // namespace tumble
