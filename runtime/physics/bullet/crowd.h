// Bodies that a script created within each other overlap by the hundred, and pairs go by the square of their number. Until
// they have come apart to where neighbours are near neighbours, some of the pairs are enough to drive them apart.
#pragma once

#include <vector>

#include "physics/bullet/body_pair.h"

namespace tumble {

class Crowd {
 public:
  // Of the contacts that a look found, once movers are known.
  explicit Crowd(const std::vector<KeptContact*>& found);
  // Is it one of too many deep ones? The choice is the same in each step, and only grows as the crowd thins out.
  bool leaves_out(const KeptContact& kept) const;

 private:
  bool any_ = false;  // does any body have too many?
};

}  // namespace tumble
