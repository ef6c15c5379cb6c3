#include "assets/image.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "render/renderer.h"

using namespace tumble;

namespace {

struct TemporaryFile {
  std::string path = (std::filesystem::temp_directory_path() / "tumble_test_image.png").string();
  ~TemporaryFile() { std::filesystem::remove(path); }
};

}  // namespace

TEST_CASE("image: a picture that is written reads back the same", "[assets][render]") {
  const TemporaryFile file;
  const Picture picture{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30}};

  write_png(picture, file.path);
  const Image image = load_image(file.path);

  CHECK(image.width == 2);
  CHECK(image.height == 2);
  CHECK(image.pixels == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 10, 20, 30, 255});
}

TEST_CASE("image: what is no picture is refused by name", "[assets]") {
  CHECK_THROWS_WITH(read_image("local x = 1", "player.lua"),
                    Catch::Contains("'player.lua' is no picture") && Catch::Contains("give a PNG"));
  CHECK_THROWS_WITH(load_image("nowhere/ball.png"), Catch::Contains("cannot read 'nowhere/ball.png'"));
}

TEST_CASE("image: a damaged file is refused", "[assets]") {
  const TemporaryFile file;
  write_png({64, 64, std::vector<std::uint8_t>(64 * 64 * 3, 7)}, file.path);
  std::ifstream in(file.path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});

  CHECK_THROWS_AS(read_image(bytes.substr(0, 50), "half.png"), Error);
}

TEST_CASE("image: a bomb is refused before it is unpacked", "[assets]") {
  // A PNG's first chunk says 100000 x 100000.
  std::string bomb = "\x89PNG\r\n\x1a\n";
  bomb += std::string("\0\0\0\x0dIHDR\0\x01\x86\xa0\0\x01\x86\xa0\x08\x02\0\0\0", 21) + std::string(64, '\0');

  CHECK_THROWS_AS(read_image(bomb, "bomb.png"), Error);
}

TEST_CASE("picture: where it cannot be written the message says which file", "[render]") {
  const Picture picture{1, 1, {1, 2, 3}};

  CHECK_THROWS_WITH(write_png(picture, "no/such/folder/a.png"), Catch::Contains("no/such/folder/a.png"));
  CHECK_THROWS_WITH(write_png({}, "a.png"), Catch::Contains("there is none to write"));
}
