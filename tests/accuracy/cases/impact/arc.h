// The way of a body between two steps along one axis: the cubic through both places and both speeds (Hermite), which a
// parabola is a case of. It says when and how high something was where no step fell on it.
#pragma once

namespace tumble::accuracy {

struct Sample {
  double place = 0, speed = 0;  // m, m/s
};

struct Arc {
  Sample from, to;
  double seconds = 0;  // between them

  double at(double time) const;        // m
  double speed_at(double time) const;  // m/s
  // The top, inside where it rises first and falls then.
  double highest() const;
  // When it has fallen to a level between both places.
  double falls_to(double level) const;
};

}  // namespace tumble::accuracy
