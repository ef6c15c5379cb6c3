// Where widgets stand, and which of them the arrows go to.
#include <catch2/catch.hpp>

#include <sstream>

#include "base/text.h"
#include "engine/ui/focus.h"
#include "engine/ui/layout.h"
#include "engine/ui/ui.h"
#include "render/renderer.h"

using namespace tumble;

namespace {

constexpr double kWidth = 1280;

// The rectangles of what is filled, in drawing order.
std::vector<DrawPanel> panels(const std::vector<DrawUi>& drawn) {
  std::vector<DrawPanel> list;
  for (const DrawUi& entry : drawn)
    if (!entry.is_text) list.push_back(entry.panel);
  return list;
}

const DrawText& text_of(const std::vector<DrawUi>& drawn, const std::string& words) {
  for (auto entry = drawn.rbegin(); entry != drawn.rend(); ++entry)   // a shadow comes before its text
    if (entry->is_text && entry->text.text == words) return entry->text;
  throw std::runtime_error("no text " + words);
}

template <class F>
std::vector<DrawUi> drawn(Ui& ui, F content, double width = kWidth) {
  std::vector<InputEvent> none;
  ui.take_input(none, 1.0 / 60);
  std::vector<DrawUi> out;
  ui.begin({});
  content();
  ui.end(width, out);
  return out;
}

UiBoxOptions box(double width, double height) {
  UiBoxOptions options;
  options.width = width;
  options.height = height;
  return options;
}

}  // namespace

TEST_CASE("ui: a slider's knob stays clear of its number", "[ui]") {
  for (const double most : {1.0, 100.0, 12345.0}) {
    Ui ui;

    const auto out = drawn(ui, [&] {
      UiSliderOptions options;
      options.max = most;
      ui.slider("Speed", most, options);
    });

    const DrawPanel knob = panels(out).back();
    const DrawText& number = text_of(out, most == 1 ? "100 %" : number_text(most));
    INFO(number.text);
    CHECK(number.x - (knob.x + knob.width) >= 6);
  }
}

TEST_CASE("ui: an anchor keeps its distance to its edge at any width of the screen", "[ui]") {
  constexpr double margin = 24;
  for (const double width : {1280.0, 960.0, 1680.0}) {
    Ui ui;
    std::vector<DrawPanel> found;
    for (int i = 0; i < 9; ++i) {
      const auto out = drawn(ui, [&] {
        UiBoxOptions options = box(100, 50);
        options.at = static_cast<UiAnchor>(i);
        ui.box(options);
      }, width);
      found.push_back(panels(out).at(0));
    }
    for (int i = 0; i < 9; ++i) {
      INFO(width << ", " << enum_names(UiAnchor{})[static_cast<std::size_t>(i)]);
      const double xs[] = {margin, (width - 100) / 2, width - 100 - margin};
      const double ys[] = {margin, (720 - 50) / 2.0, 720 - 50 - margin};
      CHECK(found[static_cast<std::size_t>(i)].x == Approx(xs[i % 3]));
      CHECK(found[static_cast<std::size_t>(i)].y == Approx(ys[i / 3]));
    }
  }
}

TEST_CASE("ui: x and y move what is anchored, and alone they are a place", "[ui]") {
  Ui ui;
  const auto out = drawn(ui, [&] {
    UiBoxOptions options = box(100, 50);
    options.x = 7;
    options.y = -9;
    options.at = UiAnchor::bottom_right;
    ui.box(options);
    options.at.reset();
    ui.box(options);
  });
  CHECK(panels(out)[0].x == Approx(1280 - 100 - 24 + 7));
  CHECK(panels(out)[0].y == Approx(720 - 50 - 24 - 9));
  CHECK(panels(out)[1].x == Approx(7));
  CHECK(panels(out)[1].y == Approx(-9));
}

TEST_CASE("ui: a panel stacks its content and is as high as that and its padding", "[ui]") {
  Ui ui;
  const auto out = drawn(ui, [&] {
    UiPanelOptions options;
    options.at = UiAnchor::center;
    options.width = 400;
    options.padding = 20;
    options.gap = 8;
    const int depth = ui.open_panel(options);
    ui.box(box(100, 30));
    ui.space(12);
    ui.box(box(200, 50));
    ui.close(depth - 1);
  });
  const auto list = panels(out);
  REQUIRE(list.size() == 3);
  CHECK(list[0].height == Approx(20 + 30 + 8 + 12 + 8 + 50 + 20));
  CHECK(list[0].y == Approx((720 - 148) / 2.0));
  CHECK(list[1].y == Approx(list[0].y + 20));
  CHECK(list[1].x == Approx(list[0].x + 20));
  CHECK(list[2].y == Approx(list[1].y + 30 + 8 + 12 + 8));
}

TEST_CASE("ui: what stretches shares a row in equal parts, the rest keeps its width", "[ui]") {
  Ui ui;
  const auto out = drawn(ui, [&] {
    UiPanelOptions options;
    options.at = UiAnchor::top_left;
    options.width = 500;
    options.padding = 0;
    const int panel = ui.open_panel(options);
    const int row = ui.open_row();
    ui.box(box(80, 20));
    ui.bar(1, {});
    ui.bar(1, {});
    ui.close(row - 1);
    ui.close(panel - 1);
  });
  const auto list = panels(out);   // panel, box, then ground and filling of each bar
  REQUIRE(list.size() == 6);
  const double share = (500 - 80 - 2 * 10) / 2.0;
  CHECK(list[2].width == Approx(share));
  CHECK(list[4].width == Approx(share));
  CHECK(list[4].x + list[4].width == Approx(24 + 500));
}

TEST_CASE("ui: aligned lines end at the same edge, as they are measured", "[ui]") {
  Ui ui;
  const auto out = drawn(ui, [&] {
    UiTextOptions options;
    options.at = UiAnchor::top_right;
    options.align = UiAlign::right;
    options.size = 30;
    ui.text("short\na longer line", options);
  });
  for (const std::string line : {"short", "a longer line"}) {
    const DrawText& text = text_of(out, line);
    CHECK(static_cast<double>(text.x) + measure_text(line, 30).width == Approx(1280 - 24).margin(1e-3));   // floats
  }
  CHECK(text_of(out, "a longer line").y - text_of(out, "short").y == Approx(30));
}

TEST_CASE("ui: wrapped lines fit, lose no word, and are full", "[ui]") {
  const std::string words = "The quick brown fox jumps over the lazy dog and comes home late.\nNext day it sleeps.";
  const double width = 300, size = 24;
  const std::string wrapped = wrap_text(words, size, width);

  std::istringstream lines(wrapped);
  std::string line, before;
  while (std::getline(lines, line)) {
    CHECK(measure_text(line, size).width <= width + 0.01);
    // The line before had no room for this one's first word, unless the text itself ended it there.
    if (!before.empty() && !before.ends_with("late."))
      CHECK(measure_text(before + " " + line.substr(0, line.find(' ')), size).width > width);
    before = line;
  }
  std::string joined = wrapped, plain = words;
  for (std::string* text : {&joined, &plain}) std::replace(text->begin(), text->end(), '\n', ' ');
  CHECK(joined == plain);
}

TEST_CASE("ui: a word that is wider than a line is broken between letters", "[ui]") {
  const std::string word = "Donaudampfschifffahrtsgesellschaftskapit\xC3\xA4nsm\xC3\xBCtze";
  const std::string wrapped = wrap_text(word, 24, 120);
  std::istringstream lines(wrapped);
  std::string line, joined;
  while (std::getline(lines, line)) {
    CHECK(measure_text(line, 24).width <= 120.01);
    CHECK((static_cast<unsigned char>(line[0]) & 0xC0) != 0x80);   // no letter was cut in two
    joined += line;
  }
  CHECK(joined == word);
}

TEST_CASE("ui: arrows go to the nearest ahead, and round only when asked", "[ui]") {
  //   0 1
  //   2
  //        3
  const std::vector<UiRect> all = {{0, 0, 100, 40}, {110, 0, 100, 40}, {0, 50, 100, 40}, {300, 100, 100, 40}};
  const auto next = [&](int from, UiDirection direction, bool wrap = false) {
    return next_in_direction(all[static_cast<std::size_t>(from)], all, direction, wrap);
  };
  CHECK(next(0, UiDirection::right) == 1);
  CHECK(next(1, UiDirection::left) == 0);
  CHECK(next(0, UiDirection::down) == 2);
  CHECK(next(1, UiDirection::down) == 2);      // 10 aside beats 90 aside
  CHECK(next(2, UiDirection::up) == 0);
  CHECK(next(2, UiDirection::down) == 3);
  CHECK(next(0, UiDirection::up) == -1);
  CHECK(next(0, UiDirection::left) == -1);
  CHECK(next(2, UiDirection::down, true) == 3);
  CHECK(next(0, UiDirection::up, true) == 2);  // the farthest below it
}
