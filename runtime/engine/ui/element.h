// What draw_ui() asked for in one tick, as a tree: filled by ui.cpp, placed by layout.cpp, drawn by paint.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ui/options.h"

namespace tumble {

struct UiRect {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool contains(double px, double py) const { return px >= x && py >= y && px < right() && py < bottom(); }
};

enum class UiKind { column, row, text, space, bar, box, image, button, slider, toggle, list, field, key };

// What a person can use: it has a key, takes presses and can have the focus.
constexpr bool is_widget(UiKind kind) { return kind >= UiKind::button; }

struct UiElement {
  UiKind kind = UiKind::text;
  std::vector<int> children;           // of columns and rows: indices
  int parent = -1;

  std::string key;                     // of widgets: unique in a tick
  std::string text;                    // words, label, or an image's file
  std::string value;                   // a field's text, a key's names, a slider's number
  std::vector<std::string> items;      // of a list
  int selected = 0;                    // of a list, from 1; 0 is none
  int first = 0;                       // of a list: the item shown first, from 0
  double fraction = 0;                 // of a bar or slider
  bool on = false;                     // of a toggle

  UiPlace place;                       // where it stands on its own
  std::optional<double> width, height; // as asked for
  double size = 28;                    // line height
  Color color, text_color;             // color: of a text its letters, else what is filled
  std::optional<UiAlign> align;
  double padding = 0, gap = 0, radius = 0;   // of columns and boxes
  bool visible = false;                // of columns: has a colour of its own
  bool enabled = true, focusable = false;
  bool has_widgets = false;            // of columns: something in it can be used, so that it takes presses

  UiRect rect;                         // these by lay_out_ui
  double label_width = 0, value_width = 0;   // of text and value on one line
};

// elements[0] is the screen: a column that has no edge.
using UiElements = std::vector<UiElement>;

}  // namespace tumble
