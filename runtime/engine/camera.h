// Where a camera stands that sees everything.
#pragma once

#include "assets/library.h"
#include "scene/scene.h"

namespace tumble {

struct CameraView {
  Pose pose;
  double field_of_view = 1.0471975511965976;  // vertical, rad
  double near = 0.1, far = 1000;              // m
};

// In front (towards +z) of all visible meshes and a little above them, with a sphere around them in view.
CameraView framing(const Scene& scene, AssetLibrary* assets);

}  // namespace tumble
