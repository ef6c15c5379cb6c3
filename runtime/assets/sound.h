// Sounds read from memory: WAV (8 to 32 bits, whole numbers or floats) and OGG with Vorbis, of one or two channels.
#pragma once

#include <string>
#include <string_view>

#include "base/pcm.h"

namespace tumble {

// Games come from anybody: a longer sound is refused before memory is taken for it. A sound is kept whole, decoded.
constexpr double kLongestSound = 600;  // s
constexpr int kLowestSoundRate = 2000, kHighestSoundRate = 192000;  // frames a second

// `name` is what errors call the file. Throws Error where the bytes are no such sound, damaged, empty or too long.
Pcm read_sound(std::string_view bytes, const std::string& name);

// The same for one kind of file each; read_sound() looks at the first bytes and calls them.
Pcm read_wav(std::string_view bytes, const std::string& name);
Pcm read_ogg(std::string_view bytes, const std::string& name);
// Throws Error for a shape of sound that is refused. `frames` is what the file promises.
void check_sound(const std::string& name, int channels, double rate, double frames);

}  // namespace tumble
