// SDL's names for keys, buttons and pad controls, in our words (platform/input.h).
#pragma once

#include <SDL.h>

namespace tumble {

// Each gives nullptr for what has no raw name. Keys go by their place on the board, not by what is printed on them.
const char* key_name(SDL_Scancode key);
const char* pointer_name(int button);
// Without the leading "pad_".
const char* pad_button_name(int button);

// A stick's axis has a name for each direction, a trigger only one.
struct PadAxisNames {
  const char* positive;
  const char* negative;
};
PadAxisNames pad_axis_names(int axis);

}  // namespace tumble
