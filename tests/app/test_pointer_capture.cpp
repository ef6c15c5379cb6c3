#include "app/pointer_capture.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

WindowEvents pressed(const std::string& name) {
  WindowEvents events;
  events.input.push_back({InputKind::press, name});
  return events;
}
WindowEvents focus(bool gained) {
  WindowEvents events;
  (gained ? events.focus_gained : events.focus_lost) = true;
  return events;
}

}  // namespace

TEST_CASE("pointer capture: the game has it while it wants it and plays", "[app]") {
  PointerCapture capture;
  CHECK_FALSE(capture.update({}, false, true));
  CHECK(capture.update({}, true, true));
  CHECK_FALSE(capture.update({}, true, false));
  CHECK(capture.update({}, true, true));
  CHECK_FALSE(capture.update({}, false, true));
}

TEST_CASE("pointer capture: another window in front frees it", "[app]") {
  PointerCapture capture;
  capture.update({}, true, true);
  CHECK_FALSE(capture.update(focus(false), true, true));
  CHECK_FALSE(capture.update({}, true, true));
  CHECK(capture.update(focus(true), true, true));
}

TEST_CASE("pointer capture: escape frees it until the next click", "[app]") {
  PointerCapture capture;
  capture.update({}, true, true);
  CHECK_FALSE(capture.update(pressed("escape"), true, true));
  CHECK_FALSE(capture.update(pressed("w"), true, true));
  CHECK(capture.update(pressed("pointer"), true, true));
}

TEST_CASE("pointer capture: a game that pauses and goes on by escape has it again", "[app]") {
  PointerCapture capture;
  capture.update({}, true, true);
  capture.update(pressed("escape"), true, true);
  CHECK_FALSE(capture.update({}, true, false));
  CHECK_FALSE(capture.update(pressed("escape"), true, false));
  CHECK(capture.update({}, true, true));
}

TEST_CASE("pointer capture: a game that asks anew has it again", "[app]") {
  PointerCapture capture;
  capture.update({}, true, true);
  capture.update(pressed("escape"), true, true);
  capture.update({}, false, true);
  CHECK(capture.update({}, true, true));
}
