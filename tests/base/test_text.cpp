#include "base/text.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>

using namespace tumble;

TEST_CASE("text: the nearest word has one letter wrong, missing, too many or swapped", "[base]") {
  const std::vector<std::string> words = {"orange", "blue", "mass"};
  for (const char* wrong : {"oragne", "orang", "orangee", "oronge", "ORANGE", "orange"}) CHECK(nearest(wrong, words) == "orange");
  CHECK(nearest("mas", words) == "mass");
}

TEST_CASE("text: nothing is near when more than a third of the letters differ", "[base]") {
  CHECK(nearest("purple", {"orange", "blue"}).empty());
  CHECK(nearest("x", {"y"}).empty());
  CHECK(nearest("", {"y"}).empty());
  CHECK(nearest(std::string(1000, 'a'), {std::string(1000, 'a')}).empty());
}

TEST_CASE("text: the first of equally near words wins", "[base]") { CHECK(nearest("colaur", {"colour", "colaor"}) == "colour"); }

TEST_CASE("text: a suggestion is a half sentence, or nothing", "[base]") {
  CHECK(did_you_mean("mas", {"mass"}) == "; did you mean 'mass'?");
  CHECK(did_you_mean("weight", {"mass"}).empty());
}

TEST_CASE("text: numbers are written as short as they can be read back", "[base]") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(3) == "3");
  CHECK(number_text(-0.5) == "-0.5");
  for (const double value : {1.0 / 3, 1e-300, 1.7976931348623157e308, 0.1 + 0.2, 123456789.123456789})
    CHECK(std::strtod(number_text(value).c_str(), nullptr) == value);
}

TEST_CASE("text: words are joined with a separator between them only", "[base]") {
  CHECK(join({}) == "");
  CHECK(join({"a"}) == "a");
  CHECK(join({"a", "b", "c"}) == "a, b, c");
  CHECK(join({"a", "b"}, " or ") == "a or b");
}

TEST_CASE("text: valid UTF-8 is told from broken", "[base]") {
  for (const char* good : {"", "plain", "gr\xc3\xbc\xc3\x9f", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"}) CHECK(is_utf8(good));
  const char* const broken[] = {"\x80",         "\xc3",         "\xc3(",         "\xc0\xaf",        "\xe0\x80\xaf", "\xed\xa0\x80",
                                "\xf4\x90\x80\x80", "\xf0\x80\x80\x80", "\xff", "\xe2\x82", "a\xfe"};
  for (const char* bad : broken) CHECK_FALSE(is_utf8(bad));
}
