// What scripts may say of each widget, and how all of them look: the options tables of ui.*, described once.
//
// Lengths are in ui units: the screen is 720 of them high whatever the window.
#pragma once

#include <optional>
#include <string>

#include "base/color.h"
#include "base/describe.h"

namespace tumble {

constexpr double kUiHeight = 720;

enum class UiAnchor { top_left, top, top_right, left, center, right, bottom_left, bottom, bottom_right };
const EnumNames& enum_names(UiAnchor);
enum class UiAlign { left, center, right };
const EnumNames& enum_names(UiAlign);

// ui.style: what widgets look like that say nothing else.
struct UiStyle {
  Color accent{1.0, 0.72, 0.26, 1};
  Color panel{0.07, 0.09, 0.13, 0.88};
  Color text{0.96, 0.97, 0.98, 1};
  double size = 28;
};
void describe(UiStyle& style, Schema& s);

// Where something goes that stands on its own: a named place moved by x and y, or x and y alone.
struct UiPlace {
  std::optional<UiAnchor> at;
  std::optional<double> x, y;
  bool is_given() const { return at || x || y; }
};

struct UiTextOptions : UiPlace {
  std::optional<double> size, width;
  std::optional<Color> color;
  std::optional<UiAlign> align;
};
void describe(UiTextOptions& options, Schema& s);

// What buttons, toggles and keys take, and sliders, lists and fields too.
struct UiWidgetOptions : UiPlace {
  std::optional<std::string> id;
  std::optional<double> width, size;
  std::optional<Color> color, text_color;
  bool enabled = true;
  std::optional<bool> focus;
};
void describe(UiWidgetOptions& options, Schema& s);

struct UiSliderOptions : UiWidgetOptions {
  double min = 0, max = 1, step = 0;
};
void describe(UiSliderOptions& options, Schema& s);

struct UiListOptions : UiWidgetOptions {
  std::optional<double> height;
};
void describe(UiListOptions& options, Schema& s);

struct UiFieldOptions : UiWidgetOptions {
  int length = 16;
};
void describe(UiFieldOptions& options, Schema& s);

struct UiBarOptions : UiPlace {
  std::optional<double> width;
  double height = 16;
  std::optional<Color> color;
};
void describe(UiBarOptions& options, Schema& s);

struct UiBoxOptions : UiPlace {
  double width = 240, height = 120, radius = 0;
  Color color{0, 0, 0, 0.55};
};
void describe(UiBoxOptions& options, Schema& s);

struct UiImageOptions : UiPlace {
  std::optional<double> width, height;
  Color color{1, 1, 1, 1};
};
void describe(UiImageOptions& options, Schema& s);

struct UiPanelOptions : UiPlace {
  std::optional<double> width, height;
  std::optional<Color> color;
  UiAlign align = UiAlign::left;
  double padding = 24, gap = 10, radius = 16;
  bool focus = true;
};
void describe(UiPanelOptions& options, Schema& s);

}  // namespace tumble
