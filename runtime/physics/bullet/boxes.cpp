#include "physics/bullet/boxes.h"

#include <algorithm>

namespace tumble {

void Boxes::add(Occupant& occupant, const btDbvtVolume& box) { occupant.leaf = tree_of(occupant).insert(box, &occupant); }

void Boxes::move(Occupant& occupant, const btDbvtVolume& box) {
  btDbvtVolume copy = box;
  tree_of(occupant).update(occupant.leaf, copy);
}

void Boxes::remove(Occupant& occupant) {
  tree_of(occupant).remove(occupant.leaf);
  occupant.leaf = nullptr;
}

double Boxes::reach() const {
  double most = 0;
  for (const btDbvt* tree : {&moving_, &fixed_})
    if (tree->m_root) most = std::max({most, tree->m_root->volume.Mins().length(), tree->m_root->volume.Maxs().length()});
  return most;
}

}  // namespace tumble
