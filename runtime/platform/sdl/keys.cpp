#include "platform/sdl/keys.h"

namespace tumble {
namespace {

struct Row {
  int code;
  const char* name;
};

constexpr Row kKeys[] = {
    {SDL_SCANCODE_A, "a"}, {SDL_SCANCODE_B, "b"}, {SDL_SCANCODE_C, "c"}, {SDL_SCANCODE_D, "d"},
    {SDL_SCANCODE_E, "e"}, {SDL_SCANCODE_F, "f"}, {SDL_SCANCODE_G, "g"}, {SDL_SCANCODE_H, "h"},
    {SDL_SCANCODE_I, "i"}, {SDL_SCANCODE_J, "j"}, {SDL_SCANCODE_K, "k"}, {SDL_SCANCODE_L, "l"},
    {SDL_SCANCODE_M, "m"}, {SDL_SCANCODE_N, "n"}, {SDL_SCANCODE_O, "o"}, {SDL_SCANCODE_P, "p"},
    {SDL_SCANCODE_Q, "q"}, {SDL_SCANCODE_R, "r"}, {SDL_SCANCODE_S, "s"}, {SDL_SCANCODE_T, "t"},
    {SDL_SCANCODE_U, "u"}, {SDL_SCANCODE_V, "v"}, {SDL_SCANCODE_W, "w"}, {SDL_SCANCODE_X, "x"},
    {SDL_SCANCODE_Y, "y"}, {SDL_SCANCODE_Z, "z"},
    {SDL_SCANCODE_0, "0"}, {SDL_SCANCODE_1, "1"}, {SDL_SCANCODE_2, "2"}, {SDL_SCANCODE_3, "3"},
    {SDL_SCANCODE_4, "4"}, {SDL_SCANCODE_5, "5"}, {SDL_SCANCODE_6, "6"}, {SDL_SCANCODE_7, "7"},
    {SDL_SCANCODE_8, "8"}, {SDL_SCANCODE_9, "9"},
    {SDL_SCANCODE_SPACE, "space"}, {SDL_SCANCODE_RETURN, "enter"}, {SDL_SCANCODE_ESCAPE, "escape"},
    {SDL_SCANCODE_TAB, "tab"}, {SDL_SCANCODE_BACKSPACE, "backspace"}, {SDL_SCANCODE_INSERT, "insert"},
    {SDL_SCANCODE_DELETE, "delete"}, {SDL_SCANCODE_HOME, "home"}, {SDL_SCANCODE_END, "end"},
    {SDL_SCANCODE_PAGEUP, "page_up"}, {SDL_SCANCODE_PAGEDOWN, "page_down"}, {SDL_SCANCODE_LEFT, "left"},
    {SDL_SCANCODE_RIGHT, "right"}, {SDL_SCANCODE_UP, "up"}, {SDL_SCANCODE_DOWN, "down"},
    {SDL_SCANCODE_LSHIFT, "left_shift"}, {SDL_SCANCODE_RSHIFT, "right_shift"}, {SDL_SCANCODE_LCTRL, "left_ctrl"},
    {SDL_SCANCODE_RCTRL, "right_ctrl"}, {SDL_SCANCODE_LALT, "left_alt"}, {SDL_SCANCODE_RALT, "right_alt"},
    {SDL_SCANCODE_LGUI, "left_super"}, {SDL_SCANCODE_RGUI, "right_super"}, {SDL_SCANCODE_CAPSLOCK, "caps_lock"},
    {SDL_SCANCODE_NUMLOCKCLEAR, "num_lock"}, {SDL_SCANCODE_SCROLLLOCK, "scroll_lock"},
    {SDL_SCANCODE_PRINTSCREEN, "print_screen"}, {SDL_SCANCODE_PAUSE, "pause"}, {SDL_SCANCODE_APPLICATION, "menu"},
    {SDL_SCANCODE_MINUS, "minus"}, {SDL_SCANCODE_EQUALS, "equals"}, {SDL_SCANCODE_LEFTBRACKET, "left_bracket"},
    {SDL_SCANCODE_RIGHTBRACKET, "right_bracket"}, {SDL_SCANCODE_BACKSLASH, "backslash"},
    {SDL_SCANCODE_NONUSHASH, "backslash"}, {SDL_SCANCODE_SEMICOLON, "semicolon"},
    {SDL_SCANCODE_APOSTROPHE, "apostrophe"}, {SDL_SCANCODE_GRAVE, "grave"}, {SDL_SCANCODE_COMMA, "comma"},
    {SDL_SCANCODE_PERIOD, "period"}, {SDL_SCANCODE_SLASH, "slash"}, {SDL_SCANCODE_NONUSBACKSLASH, "less"},
    {SDL_SCANCODE_F1, "f1"}, {SDL_SCANCODE_F2, "f2"}, {SDL_SCANCODE_F3, "f3"}, {SDL_SCANCODE_F4, "f4"},
    {SDL_SCANCODE_F5, "f5"}, {SDL_SCANCODE_F6, "f6"}, {SDL_SCANCODE_F7, "f7"}, {SDL_SCANCODE_F8, "f8"},
    {SDL_SCANCODE_F9, "f9"}, {SDL_SCANCODE_F10, "f10"}, {SDL_SCANCODE_F11, "f11"}, {SDL_SCANCODE_F12, "f12"},
    {SDL_SCANCODE_KP_0, "keypad_0"}, {SDL_SCANCODE_KP_1, "keypad_1"}, {SDL_SCANCODE_KP_2, "keypad_2"},
    {SDL_SCANCODE_KP_3, "keypad_3"}, {SDL_SCANCODE_KP_4, "keypad_4"}, {SDL_SCANCODE_KP_5, "keypad_5"},
    {SDL_SCANCODE_KP_6, "keypad_6"}, {SDL_SCANCODE_KP_7, "keypad_7"}, {SDL_SCANCODE_KP_8, "keypad_8"},
    {SDL_SCANCODE_KP_9, "keypad_9"}, {SDL_SCANCODE_KP_PLUS, "keypad_plus"}, {SDL_SCANCODE_KP_MINUS, "keypad_minus"},
    {SDL_SCANCODE_KP_MULTIPLY, "keypad_multiply"}, {SDL_SCANCODE_KP_DIVIDE, "keypad_divide"},
    {SDL_SCANCODE_KP_ENTER, "keypad_enter"}, {SDL_SCANCODE_KP_PERIOD, "keypad_period"}};

constexpr Row kPointerButtons[] = {{SDL_BUTTON_LEFT, "pointer"},
                                   {SDL_BUTTON_RIGHT, "pointer_right"},
                                   {SDL_BUTTON_MIDDLE, "pointer_middle"},
                                   {SDL_BUTTON_X1, "pointer_back"},
                                   {SDL_BUTTON_X2, "pointer_forward"}};

constexpr Row kPadButtons[] = {
    {SDL_CONTROLLER_BUTTON_A, "a"}, {SDL_CONTROLLER_BUTTON_B, "b"}, {SDL_CONTROLLER_BUTTON_X, "x"},
    {SDL_CONTROLLER_BUTTON_Y, "y"}, {SDL_CONTROLLER_BUTTON_BACK, "back"}, {SDL_CONTROLLER_BUTTON_GUIDE, "guide"},
    {SDL_CONTROLLER_BUTTON_START, "start"}, {SDL_CONTROLLER_BUTTON_LEFTSTICK, "left_stick"},
    {SDL_CONTROLLER_BUTTON_RIGHTSTICK, "right_stick"}, {SDL_CONTROLLER_BUTTON_LEFTSHOULDER, "left_shoulder"},
    {SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, "right_shoulder"}, {SDL_CONTROLLER_BUTTON_DPAD_UP, "up"},
    {SDL_CONTROLLER_BUTTON_DPAD_DOWN, "down"}, {SDL_CONTROLLER_BUTTON_DPAD_LEFT, "left"},
    {SDL_CONTROLLER_BUTTON_DPAD_RIGHT, "right"}};

template <std::size_t n>
const char* find(const Row (&rows)[n], int code) {
  for (const Row& row : rows)
    if (row.code == code) return row.name;
  return nullptr;
}

}  // namespace

const char* key_name(SDL_Scancode key) { return find(kKeys, key); }
const char* pointer_name(int button) { return find(kPointerButtons, button); }
const char* pad_button_name(int button) { return find(kPadButtons, button); }

PadAxisNames pad_axis_names(int axis) {
  switch (axis) {
    case SDL_CONTROLLER_AXIS_LEFTX: return {"left_x+", "left_x-"};
    case SDL_CONTROLLER_AXIS_LEFTY: return {"left_y-", "left_y+"};  // SDL's y points down
    case SDL_CONTROLLER_AXIS_RIGHTX: return {"right_x+", "right_x-"};
    case SDL_CONTROLLER_AXIS_RIGHTY: return {"right_y-", "right_y+"};
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT: return {"left_trigger", nullptr};
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT: return {"right_trigger", nullptr};
    default: return {nullptr, nullptr};
  }
}

}  // namespace tumble
