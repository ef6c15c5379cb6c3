// Where everything stands: columns stack, rows stand side by side, the screen's corners and edges anchor the rest.
#pragma once

#include "engine/ui/element.h"

namespace tumble {

// Fills each element's rect. The screen is `width` by kUiHeight.
void lay_out_ui(UiElements& elements, double width);

// The parts within a widget, for drawing it and for using it.
constexpr double ui_row_height(double size) { return 1.7 * size; }      // of a widget of one line
constexpr double ui_inset(double size) { return 0.7 * size; }           // from its edge to its text
UiRect ui_slider_track(const UiElement& slider);
constexpr double ui_list_padding = 6;
int ui_shown_items(const UiElement& list);                              // how many fit
double ui_item_height(const UiElement& list);                           // where it scrolls, they fill it

// Lines broken between words, or within one that is wider than `width` itself; existing line feeds stay.
std::string wrap_text(const std::string& text, double size, double width);

}  // namespace tumble
