// Pads that SDL makes up for us, plugged in and pulled out while somebody plays.
#include "platform/sdl/pads.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

using namespace tumble;
using Catch::Contains;
using Texts = std::vector<std::string>;

namespace {

// A made-up pad, from now until the end of the test or until it is pulled out.
class MadeUpPad {
 public:
  explicit MadeUpPad(const char* name = "Made Up", SDL_JoystickType type = SDL_JOYSTICK_TYPE_GAMECONTROLLER) {
    SDL_VirtualJoystickDesc desc{};
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = static_cast<Uint16>(type);
    desc.naxes = SDL_CONTROLLER_AXIS_MAX;
    desc.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    desc.name = name;
    desc.userdata = this;
    desc.Rumble = [](void* self, Uint16 low, Uint16 high) {
      static_cast<MadeUpPad*>(self)->rumbles.emplace_back(low, high);
      return 0;
    };
    const int index = SDL_JoystickAttachVirtualEx(&desc);
    REQUIRE(index >= 0);
    id_ = SDL_JoystickGetDeviceInstanceID(index);
  }
  ~MadeUpPad() { pull_out(); }
  MadeUpPad(const MadeUpPad&) = delete;

  void button(int button, bool down) { SDL_JoystickSetVirtualButton(joystick(), button, down); }
  void axis(int axis, double value) { SDL_JoystickSetVirtualAxis(joystick(), axis, static_cast<Sint16>(value * 32767)); }
  void pull_out() {
    for (int i = 0; i < SDL_NumJoysticks(); ++i)
      if (SDL_JoystickGetDeviceInstanceID(i) == id_) SDL_JoystickDetachVirtual(i);
  }
  std::vector<std::pair<int, int>> rumbles;

 private:
  SDL_Joystick* joystick() const { return SDL_JoystickFromInstanceID(id_); }
  SDL_JoystickID id_ = -1;
};

struct Player {
  Pads pads;
  HeldInput held;
  Texts notes;

  Player() { pads.start(); }
  // "+name" for a press, "-name" for a release, "name value" for a value, of what happened since.
  Texts told() {
    WindowEvents out;
    SDL_JoystickUpdate();
    SDL_PumpEvents();
    for (SDL_Event event; SDL_PollEvent(&event);) pads.handle(event, held, out);
    Texts texts;
    for (const InputEvent& event : out.input) {
      if (event.kind == InputKind::press) texts.push_back("+" + event.name);
      if (event.kind == InputKind::release) texts.push_back("-" + event.name);
      if (event.kind == InputKind::value) texts.push_back(event.name + " " + std::to_string(event.value).substr(0, 4));
    }
    notes = out.notes;
    return texts;
  }
};

}  // namespace

TEST_CASE("pads: without one there is nothing and no error", "[platform]") {
  Player player;
  CHECK(player.told().empty());
  CHECK(player.notes.empty());
  CHECK_NOTHROW(player.pads.rumble(0, 1, 1));
}

TEST_CASE("pads: a button comes as that of any pad and of this one", "[platform]") {
  Player player;
  MadeUpPad pad;
  player.told();
  CHECK(player.notes == Texts{"pad 1 is here: Made Up"});

  pad.button(SDL_CONTROLLER_BUTTON_A, true);
  CHECK(player.told() == Texts{"+pad1_a", "+pad_a"});
  pad.button(SDL_CONTROLLER_BUTTON_A, false);
  CHECK(player.told() == Texts{"-pad1_a", "-pad_a"});
}

TEST_CASE("pads: any pad's button is down while one of two holds it", "[platform]") {
  Player player;
  MadeUpPad first("One"), second("Two");
  player.told();
  CHECK(player.notes == Texts{"pad 1 is here: One", "pad 2 is here: Two"});

  first.button(SDL_CONTROLLER_BUTTON_B, true);
  player.told();
  second.button(SDL_CONTROLLER_BUTTON_B, true);
  CHECK(player.told() == Texts{"+pad2_b"});
  first.button(SDL_CONTROLLER_BUTTON_B, false);
  CHECK(player.told() == Texts{"-pad1_b"});
  second.button(SDL_CONTROLLER_BUTTON_B, false);
  CHECK(player.told() == Texts{"-pad2_b", "-pad_b"});
}

TEST_CASE("pads: a stick at rest is silent, and its way is stretched over 0 to 1", "[platform]") {
  Player player;
  MadeUpPad pad;
  player.told();

  pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 0.1);
  CHECK(player.told().empty());
  // (0.32 - 0.15) / 0.85 = 0.2, and y points up.
  pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 0.32);
  pad.axis(SDL_CONTROLLER_AXIS_LEFTY, -1);
  const Texts told = player.told();
  CHECK_THAT(told, Catch::VectorContains(std::string("pad_left_x+ 0.19")) || Catch::VectorContains(std::string("pad_left_x+ 0.20")));
  CHECK_THAT(told, Catch::VectorContains(std::string("pad_left_y+ 1.00")));
  CHECK_THAT(told, Catch::VectorContains(std::string("+pad_left_y+")));
  // From one side to the other in one step: never both.
  pad.axis(SDL_CONTROLLER_AXIS_LEFTX, -1);
  const Texts turned = player.told();
  CHECK(std::find(turned.begin(), turned.end(), "pad1_left_x+ 0.00") < std::find(turned.begin(), turned.end(), "pad1_left_x- 1.00"));
}

TEST_CASE("pads: pulled out in play, everything held is let go and a sentence says so", "[platform]") {
  Player player;
  MadeUpPad pad;
  player.told();
  pad.button(SDL_CONTROLLER_BUTTON_A, true);
  pad.axis(SDL_CONTROLLER_AXIS_RIGHTX, 1);
  player.told();

  pad.pull_out();
  const Texts told = player.told();

  CHECK(player.notes == Texts{"pad 1 is gone: Made Up"});
  for (const char* text : {"-pad1_a", "-pad_a", "-pad1_right_x+", "-pad_right_x+", "pad_right_x+ 0.00"}) CHECK_THAT(told, Catch::VectorContains(std::string(text)));
  CHECK(std::none_of(told.begin(), told.end(), [](const std::string& text) { return text.starts_with('+'); }));
  CHECK(player.told().empty());
}

TEST_CASE("pads: one that comes back takes the number that is free", "[platform]") {
  Player player;
  MadeUpPad first("One"), second("Two");
  player.told();
  first.pull_out();
  player.told();

  MadeUpPad third("Three");
  player.told();
  CHECK(player.notes == Texts{"pad 1 is here: Three"});
  third.button(SDL_CONTROLLER_BUTTON_X, true);
  CHECK(player.told() == Texts{"+pad1_x", "+pad_x"});
}

TEST_CASE("pads: a fifth one, or one with unknown buttons, is not used, with a sentence", "[platform]") {
  Player player;
  MadeUpPad one, two, three, four, five("Fifth"), wheel("Wheel", SDL_JOYSTICK_TYPE_WHEEL);
  player.told();

  REQUIRE(player.notes.size() == 6);
  CHECK_THAT(player.notes, Catch::VectorContains(std::string("'Fifth' is not used: there are 4 pads already")));
  CHECK(std::any_of(player.notes.begin(), player.notes.end(), [](const std::string& note) { return note.starts_with("'Wheel' is not used: nobody has told SDL"); }));
}

TEST_CASE("pads: rumble goes to the pad that is meant, or to all", "[platform]") {
  Player player;
  MadeUpPad first, second;
  player.told();

  player.pads.rumble(2, 0.5, 0.2);
  CHECK(first.rumbles.empty());
  CHECK(second.rumbles == std::vector<std::pair<int, int>>{{32768, 32768}});
  player.pads.rumble(0, 1, 0.2);
  CHECK(first.rumbles.back() == std::pair(65535, 65535));
  player.pads.rumble(0, 0, 0);
  CHECK(first.rumbles.back() == std::pair(0, 0));
}
