// The colliders of a node's body: given ones stretched by the node's scale, or fitted to its mesh or scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/body.h"

namespace tumble {

// What the world gets for a body written as `def` on a node with this mesh and world scale. Throws Error beginning
// with `call` where there is nothing to fit to.
BodyDef fitted(const BodyDef& def, const std::optional<Shape>& mesh, Vec3 scale, const std::string& call);

}  // namespace tumble
