// The colliders of a node's body: given ones stretched by the node's scale, or fitted to its mesh or scale.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "physics/body.h"

namespace tumble {

// Gives a shape the points of its file.
using WithPoints = std::function<Shape(const Shape&)>;

// What the world gets for a body written as `def` on a node with this mesh and world scale. A mesh from a file becomes
// its triangles, of a dynamic body or a trigger the hull around it. Throws Error beginning with `call` where there is
// nothing to fit to.
BodyDef fitted(const BodyDef& def, const std::optional<Shape>& mesh, Vec3 scale, const WithPoints& with_points, const std::string& call);

}  // namespace tumble
