// Small text helpers: the nearest known word, numbers as short as they can be read back, lists in sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

// The word most like `wrong`, or "" where none is near: at most a third of the longer word's letters differ
// (inserted, left out, replaced, or two neighbours swapped), upper and lower case counting as equal.
std::string nearest(std::string_view wrong, const std::vector<std::string>& words);
// "; did you mean 'red'?", or "" where nothing is near.
std::string did_you_mean(std::string_view wrong, const std::vector<std::string>& words);
// The shortest decimal text that reads back as the same double.
std::string number_text(double value);
// "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");
// Is this valid UTF-8?
bool is_utf8(std::string_view text);


}  // namespace tumble
