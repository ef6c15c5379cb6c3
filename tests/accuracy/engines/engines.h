#pragma once

#include "accuracy/simulation.h"

namespace tumble::accuracy {

std::unique_ptr<Simulation> make_tumble(const SceneSettings& settings, const Knobs& knobs);
// In a shared library of its own: its Bullet is another build with the same names.
__attribute__((visibility("default"))) std::unique_ptr<Simulation> make_stock(const SceneSettings& settings, const Knobs& knobs);

}  // namespace tumble::accuracy
