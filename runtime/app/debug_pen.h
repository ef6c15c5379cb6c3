// Draws what the debug view shows into a draw list, from world places.
#pragma once

#include "engine/engine.h"
#include "physics/wire.h"
#include "render/draw_list.h"

namespace tumble {

class DebugPen {
 public:
  DebugPen(DrawList& list, double aspect) : list_(list), aspect_(aspect) {}

  void line(Vec3 from, Vec3 to, const Color& color, bool on_top = true);
  void arrow(Vec3 from, Vec3 to, const Color& color);
  void cross(Vec3 at, double size, const Color& color);
  void arc(Vec3 center, Vec3 u, Vec3 v, double angle, const Color& color);
  // As it is seen, and what is hidden faintly through everything.
  void wire(const Wire& wire, const Pose& pose, const Color& color);
  // Centred over a place in the world; nothing where it lies behind the camera.
  void label(Vec3 at, const std::string& text, const Color& color);

 private:
  DrawList& list_;
  double aspect_;
};

// The joint's frames, what it leaves free, its limits and where it is between them. `pose_of` gives the pose of a body,
// of the default handle that of the world.
void draw_joint(DebugPen& pen, const DebugJoint& joint, const std::function<Pose(BodyId)>& pose_of);

}  // namespace tumble
