// Which contact points of a look are those of the look before: what pressed there still does.
#pragma once

#include <cmath>

namespace tumble {

// Points that lie nearer on either body are one, as a part of the smaller one: where edges nearly lie on each other, their
// crossing runs far along them for a hair of a turn.
constexpr double kSamePoint = 0.15;
// Cosine of the angle within which an impulse along the old normal says something about the new one.
constexpr double kSameNormal = 0.9;

// Calls same(i, k) for each pair of an old and a new point of which distance(i, k) is less than `near`, each point in one
// pair at most; the nearest two first, so that one that moved far does not take its neighbour's impulse. At most 16 old
// and 4 new ones.
template <class Distance, class Same>
void match_points(int olds, int news, double near, const Distance& distance, const Same& same) {
  bool taken[16] = {}, done[4] = {};
  if (olds == 1 && news == 1) near = INFINITY;  // what rolls has one point, and it runs
  for (;;) {
    int from = -1, to = -1;
    double least = near;
    for (int i = 0; i < olds; ++i)
      for (int k = 0; k < news && !taken[i]; ++k) {
        if (done[k]) continue;
        if (const double d = distance(i, k); d < least) least = d, from = i, to = k;
      }
    if (from < 0) return;
    taken[from] = done[to] = true;
    same(from, to);
  }
}

}  // namespace tumble
