// Whole games by ear: what would come out of the loudspeakers while they are played.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "assets/temporary_folder.h"
#include "support/source_tree.h"
#include "support/wav.h"
#include "tumble/tumble.h"

using namespace tumble;

namespace {

constexpr int kSamplesPerTick = 2 * 48000 / 60;   // left and right

Options listening(bool bot = false) {
  Options options;
  options.sound_track = true;
  options.bot = bot;
  return options;
}

std::vector<float> hear(Runtime& runtime, int ticks) {
  runtime.take_sound();
  runtime.tick(ticks);
  return runtime.take_sound();
}

float peak(const std::vector<float>& samples) {
  float most = 0;
  for (const float sample : samples) most = std::max(most, std::abs(sample));
  return most;
}

// Root of the mean square of one side.
double loudness(const std::vector<float>& samples, int side) {
  double sum = 0;
  for (std::size_t i = static_cast<std::size_t>(side); i < samples.size(); i += 2) sum += double{samples[i]} * samples[i];
  return std::sqrt(sum / std::max<std::size_t>(1, samples.size() / 2));
}

// From the title into the round.
void begin(Runtime& runtime, const std::string& game) {
  runtime.load(source_tree("games/" + game).string());
  runtime.tick(2);
  runtime.press("space");
  runtime.tick(2);
  runtime.release("space");
  runtime.tick(120);
}

// The tick at which two plays of a game begin to sound different: music and the like are the same in both.
int first_difference(const std::string& game, const std::function<void(Runtime&)>& act) {
  Runtime quiet(listening()), active(listening());
  begin(quiet, game);
  begin(active, game);
  REQUIRE(hear(quiet, 1) == hear(active, 1));
  act(active);
  quiet.tick(static_cast<int>(active.tick_number() - quiet.tick_number()));
  for (int tick = 1; tick <= 120; ++tick)
    if (hear(quiet, 1) != hear(active, 1)) return tick;
  return -1;
}

struct Drop {
  TemporaryFolder folder;
  Runtime runtime{listening()};
  explicit Drop(double height) {
    folder.write("tone.wav", wav_file(tone(440, 0.2)));
    folder.write("main.lua", R"(
scene.add { name = "camera", position = vec3(0, 1, 4), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.5, 0), mesh = { shape = "box", size = vec3(9, 1, 9) }, body = "static" }
local ball = scene.add { name = "ball", position = vec3(0, 0.5 + )" + std::to_string(height) + R"(, 0), mesh = "sphere", body = {} }
function ball.on_collision_enter(hit) sound.hit("tone.wav", hit, 10) end
)");
    runtime.load(folder.path().string());
  }
};

}  // namespace

TEST_CASE("heard: a dropped ball is silent until it lands, and louder from higher", "[app][sound]") {
  // Falls of 0.45 s and 0.9 s: 26 and 53 ticks are safely before the hit, 30 and 57 safely after. 1 kg at 4.4 and 8.8 m/s.
  Drop low(1), high(4);
  CHECK(peak(hear(low.runtime, 26)) == 0);
  CHECK(peak(hear(high.runtime, 53)) == 0);

  const double soft = loudness(hear(low.runtime, 15), 0), loud = loudness(hear(high.runtime, 15), 0);

  CHECK(soft > 0.01);
  CHECK(loud / soft == Approx(2).epsilon(0.2));
}

TEST_CASE("heard: what stands at the right of the camera is louder in the right ear, and pause stops it", "[app][sound]") {
  TemporaryFolder folder;
  folder.write("tone.wav", wav_file(tone(440, 1)));
  folder.write("main.lua", R"(
scene.add { name = "camera", camera = {} }
scene.add { name = "bell", position = vec3(3, 0, 0), sound = { file = "tone.wav", loop = true, playing = true } }
function on_press() time.paused = not time.paused end
)");
  Runtime runtime(listening());
  runtime.load(folder.path().string());

  const auto played = hear(runtime, 60);
  runtime.press("p");
  hear(runtime, 12);   // it fades, so as not to click
  const auto paused = hear(runtime, 30);

  CHECK(played.size() == 60 * kSamplesPerTick);
  CHECK(loudness(played, 1) > 2 * loudness(played, 0));
  CHECK(peak(paused) == 0);
}

TEST_CASE("heard: a jump and a throw, at once", "[app][sound][games]") {
  const int jumped = first_difference("platformer", [](Runtime& r) { r.press("space"); });
  CHECK(jumped >= 1);
  CHECK(jumped <= 6);
  const int thrown = first_difference("basketball", [](Runtime& r) {
    r.press("pointer", {640, 300});
    r.tick();
    r.move_pointer({640, 480});
    r.tick();
    r.release("pointer");
  });
  CHECK(thrown >= 1);
  CHECK(thrown <= 6);
}

TEST_CASE("heard: the bot's play sounds from the title on, never silent for 3 s and never too loud", "[app][sound][games]") {
  for (const char* game : {"basketball", "platformer"}) {
    INFO(game);
    Runtime runtime(listening(true));
    runtime.load(source_tree(std::string("games/") + game).string());
    for (int second = 0; second < 30; second += 3) {
      INFO("second " << second);
      const auto heard = hear(runtime, 180);
      CHECK(loudness(heard, 0) > 0.002);   // 54 dB below full
      CHECK(loudness(heard, 1) > 0.002);
      CHECK(loudness(heard, 0) < 0.35);
      CHECK(peak(heard) <= 1);
    }
  }
}
