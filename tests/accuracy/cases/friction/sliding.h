// What the friction cases share: slopes by tilted gravity, directions on the floor, and bisection.
#pragma once

#include <functional>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

// A unit vector in the floor's plane, `azimuth` from x towards z.
Vec3 on_floor(double azimuth);
// Gravity as on a slope that falls towards the azimuth; the floor itself stays level.
Vec3 on_slope(double slope, double azimuth = 0);
// How far a body has turned about y out of the pose without rotation, within half a turn.
double yaw(const Simulation& scene, BodyIndex body);
// Without its part along y.
inline Vec3 level(Vec3 v) { return {v.x, 0, v.z}; }

// Where `holds` turns from false to true between low and high.
double threshold(double low, double high, int halvings, const std::function<bool(double)>& holds);

}  // namespace tumble::accuracy
