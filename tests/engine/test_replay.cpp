#include "engine/replay.h"
#include "base/error.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

Recording sample() {
  Recording recording{"Heights", 0xfedcba9876543210ULL, 60, {}, 100, 0x0123456789abcdefULL, {}};
  recording.stored.values = {{"best", 3}, {"at", Vec3{1, 2, 3}}};
  recording.stored.bindings = {{"jump", {"k"}}};
  recording.events = {{0, {InputKind::value, kScreenShape, 4.0 / 3}},
                      {0, {InputKind::press, "space"}},
                      {0, {InputKind::value, "pad1_left_x+", 0.1}},
                      {7, {InputKind::pointer_move, "", 0, 640.5, 360, -1.25, 1e-3}},
                      {7, {InputKind::wheel, "", -2}},
                      {7, {InputKind::text, "gr\xc3\xbc\xc3\x9f \"x\""}},
                      {99, {InputKind::release, "space"}}};
  return recording;
}

std::string error(const std::string& events, const std::string& head = "") {
  try {
    read_recording(R"({"tumble_recording": 1, "game": "x", "seed": "1", "tick_rate": 60, "ticks": 10, "hash": "0", )" + head +
                       "\"events\": [" + events + "]}", "run.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("replay: a recording that was written is read back equal", "[engine]") {
  CHECK(read_recording(write_recording(sample()), "run.json") == sample());
  CHECK(read_recording(write_recording({}), "run.json") == Recording{});
}

TEST_CASE("replay: each event stands on a line of its own", "[engine]") {
  const std::string text = write_recording(sample());

  CHECK(text.find("\n    [0, \"press\", \"space\"],\n") != std::string::npos);
  CHECK(text.find("\n    [7, \"wheel\", -2.0],\n") != std::string::npos);
}

TEST_CASE("replay: broken events are told with their place", "[engine]") {
  CHECK(error(R"([1, "press", "space"])") == "no error");
  CHECK(error(R"(5)") == "run.json: events[1]: list expected, got a number");
  CHECK(error(R"([])") == "run.json: events[1]: tick is missing");
  CHECK(error(R"([-1, "press", "a"])") == "run.json: events[1]: tick: whole number from 0 expected, got -1");
  CHECK(error(R"([1, "pres", "a"])") ==
        "run.json: events[1]: unknown 'pres'; expected one of press, release, value, pointer_move, wheel, text; did you mean 'press'?");
  CHECK(error(R"([1, "press"])") == "run.json: events[1]: name is missing");
  CHECK(error(R"([1, "press", "spcae"])") == "run.json: events[1]: no key or button 'spcae'; did you mean 'space'?");
  CHECK(error(R"([1, "press", "screen_shape"])") == "run.json: events[1]: no key or button 'screen_shape'");
  CHECK(error(R"([1, "value", "pad_a", "x"])") == "run.json: events[1]: value: number expected, got a string");
  CHECK(error(R"([1, "press", "a", 5])") == "run.json: events[1] has 4 parts; 3 expected");
  CHECK(error(R"([5, "press", "a"], [4, "release", "a"])") == "run.json: events[2]: tick 4 comes after tick 5");
  CHECK(error(R"([10, "press", "a"])") == "run.json: events[1]: tick 10 is outside the recording of 10 ticks");
}

TEST_CASE("replay: a file that is no recording is refused", "[engine]") {
  CHECK_THROWS_WITH(read_recording("{}", "run.json"), "run.json: no 'tumble_recording'; it is no recording or was cut off");
  CHECK_THROWS_WITH(read_recording(R"({"tumble_recording": 2})", "run.json"),
                    "run.json: recording of version 2; this runtime reads version 1");
  CHECK_THROWS_WITH(read_recording(R"({"tumble_recording": 1, "game": "x", "seed": "xyz"})", "run.json"),
                    "run.json: seed: string of up to 16 hexadecimal digits expected, got \"xyz\"");
  const std::string text = write_recording(sample());
  CHECK_THROWS_AS(read_recording(text.substr(0, text.size() / 2), "run.json"), Error);
}
