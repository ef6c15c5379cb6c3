// Scene to draw list: what is visible, interpolated between the last two ticks.
#pragma once

#include <utility>

#include "engine/camera.h"
#include "engine/engine.h"
#include "render/draw_list.h"

namespace tumble {

// alpha 0 is the last tick, 1 this one. Without a camera the picture frames everything; without a light there is a sun.
DrawList extract(const Engine& engine, double alpha, double aspect);
// The camera as the tick sees it, for rays through the pointer: never interpolated.
CameraView camera_view(const Engine& engine);
// A ray from the camera through a point in ui units (720 high, `aspect` = width / height of the ui): from, unit direction.
std::pair<Vec3, Vec3> camera_ray(const CameraView& view, double x, double y, double aspect);
// World point to ui units; false where it lies behind the camera.
bool to_screen(const CameraView& view, Vec3 point, double aspect, double& x, double& y);

}  // namespace tumble
