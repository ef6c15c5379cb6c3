#include "engine/ui/options.h"

namespace tumble {

namespace {

void describe_place(UiPlace& place, Schema& s) {
  s.add("at", place.at, "Where it stands, if nothing stacks it: this corner, edge or middle of the screen, moved by x and y.");
  s.add("x", place.x, "Units to the right; without `at`, of its left edge from the screen's.");
  s.add("y", place.y, "Units down; without `at`, of its upper edge from the screen's.");
}

void describe_widget(UiWidgetOptions& o, Schema& s) {
  describe_place(o, s);
  s.add("id", o.id, "What tells it from others: needed where a label comes twice or changes. The label itself, where none is given.");
  s.add("width", o.width, "Units; as wide as its panel, or as it needs.").above(0);
  s.add("size", o.size, "Line height of its text, units.").above(0);
  s.add("color", o.color, "Behind its text.");
  s.add("text_color", o.text_color, "Of its text.");
  s.add("enabled", o.enabled, "Off: it is pale and cannot be used.");
  s.add("focus", o.focus, "May keys and pads reach it? True in a panel, false outside of one.");
}

}  // namespace

const EnumNames& enum_names(UiAnchor) {
  static const EnumNames names = {"top_left", "top", "top_right", "left", "center", "right", "bottom_left", "bottom", "bottom_right"};
  return names;
}

const EnumNames& enum_names(UiAlign) {
  static const EnumNames names = {"left", "center", "right"};
  return names;
}

void describe(UiStyle& style, Schema& s) {
  s.name("ui_style", "How the ui looks where a widget says nothing else.");
  s.add("accent", style.accent, "Marks what has the focus, is on or is filled.");
  s.add("panel", style.panel, "Behind panels.");
  s.add("text", style.text, "Of texts.");
  s.add("size", style.size, "Line height of texts, units.").between(8, 200);
}

void describe(UiTextOptions& o, Schema& s) {
  s.name("ui_text", "Options of ui.text.");
  describe_place(o, s);
  s.add("size", o.size, "Line height, units; what ui.style says.").above(0);
  s.add("color", o.color, "Of its letters; what ui.style says.");
  s.add("width", o.width, "Units; longer lines are broken between words.").above(0);
  s.add("align", o.align, "Where its lines stand within its width; what the panel says.");
}

void describe(UiWidgetOptions& o, Schema& s) {
  s.name("ui_button", "Options of ui.button, ui.toggle and ui.key.");
  describe_widget(o, s);
}

void describe(UiSliderOptions& o, Schema& s) {
  s.name("ui_slider", "Options of ui.slider.");
  describe_widget(o, s);
  s.add("min", o.min, "The value at its left end.");
  s.add("max", o.max, "The value at its right end.");
  s.add("step", o.step, "Values are whole steps from min; 0 allows all.").at_least(0);
}

void describe(UiListOptions& o, Schema& s) {
  s.name("ui_list", "Options of ui.list.");
  describe_widget(o, s);
  s.add("height", o.height, "Units; what does not fit is scrolled to. As high as it needs.").above(0);
}

void describe(UiFieldOptions& o, Schema& s) {
  s.name("ui_field", "Options of ui.field.");
  describe_widget(o, s);
  s.add("length", o.length, "How many letters it takes.").between(1, 200);
}

void describe(UiBarOptions& o, Schema& s) {
  s.name("ui_bar", "Options of ui.bar.");
  describe_place(o, s);
  s.add("width", o.width, "Units; as wide as its panel, or 240.").above(0);
  s.add("height", o.height, "Units.").above(0);
  s.add("color", o.color, "Of the filled part; the accent of ui.style.");
}

void describe(UiBoxOptions& o, Schema& s) {
  s.name("ui_box", "Options of ui.box.");
  describe_place(o, s);
  s.add("width", o.width, "Units.").above(0);
  s.add("height", o.height, "Units.").above(0);
  s.add("radius", o.radius, "Of its corners, units.").at_least(0);
  s.add("color", o.color, "Its colour.");
}

void describe(UiImageOptions& o, Schema& s) {
  s.name("ui_image", "Options of ui.image.");
  describe_place(o, s);
  s.add("width", o.width, "Units; where only the height is given, the picture keeps its shape.").above(0);
  s.add("height", o.height, "Units; where only the width is given, the picture keeps its shape.").above(0);
  s.add("color", o.color, "Multiplies the picture's colours.");
}

void describe(UiPanelOptions& o, Schema& s) {
  s.name("ui_panel", "Options of ui.panel.");
  describe_place(o, s);
  s.add("width", o.width, "Units; as wide as its content needs.").above(0);
  s.add("height", o.height, "Units; as high as its content needs.").above(0);
  s.add("color", o.color, "Behind it; what ui.style says.");
  s.add("align", o.align, "Where texts, rows and pictures stand that are narrower than the panel.");
  s.add("padding", o.padding, "Units between its edge and its content.").at_least(0);
  s.add("gap", o.gap, "Units between two things in it.").at_least(0);
  s.add("radius", o.radius, "Of its corners, units.").at_least(0);
  s.add("focus", o.focus, "May keys and pads reach the widgets in it?");
}

}  // namespace tumble
