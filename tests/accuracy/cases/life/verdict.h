// How a case with several pass criteria comes to one number: the worst of measured over allowed, and in words the first
// thing that was outright wrong.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

struct Verdict {
  Outcome outcome;

  void allow(double measured, double allowed) {
    require(std::isfinite(measured), "a number that is not finite");
    if (std::isfinite(measured)) outcome.error = std::max(outcome.error, measured / allowed);
  }
  // What holds or does not; where it does not, the error is that of ten times the allowed.
  bool require(bool holds, const std::string& otherwise) {
    if (holds) return true;
    if (outcome.failed.empty()) outcome.failed = otherwise;
    outcome.error = std::max(outcome.error, 10.0);
    return false;
  }
  bool require_finite(const Simulation& scene, BodyIndex body) {
    return require(finite(scene, body), "body " + std::to_string(body) + " is not finite");
  }
};

// "12.3 s", for the words of a failure.
inline std::string in_seconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", seconds);
  return text;
}

}  // namespace tumble::accuracy
