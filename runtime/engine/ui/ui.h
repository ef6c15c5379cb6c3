// Widgets without a life of their own: draw_ui() names them in each tick, and what is kept between ticks (focus, what
// is held, how far a list is scrolled) goes by their keys and ends when one is not named any more.
//
// A tick goes like this: take_input() lets the widgets that stood on the screen after the last tick have their input,
// begin() opens the screen, the calls below answer with what happened to each, end() places and draws them. So all
// that a widget says follows from recorded input.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/ui/element.h"
#include "engine/ui/focus.h"
#include "platform/input.h"
#include "render/draw_list.h"

namespace tumble {

class Ui {
 public:
  // Removes from `events` what a widget took: the game never sees those presses, nor their releases.
  void take_input(std::vector<InputEvent>& events, double tick_seconds);

  void begin(const UiStyle& style);
  void end(double screen_width, std::vector<DrawUi>& out);
  bool is_open() const { return open_; }    // between the two

  // ---- widgets; Errors begin with "ui.button: ..."
  void text(const std::string& words, const UiTextOptions& options);
  void space(double amount);
  void bar(double fraction, const UiBarOptions& options);
  void box(const UiBoxOptions& options);
  void image(const std::string& file, double natural_width, double natural_height, const UiImageOptions& options);
  bool button(const std::string& label, const UiWidgetOptions& options);
  bool toggle(const std::string& label, bool on, const UiWidgetOptions& options);
  double slider(const std::string& label, double value, const UiSliderOptions& options);
  // The item selected, from 1 (0 is none), and whether it was chosen in this tick: clicked, or enter.
  std::pair<int, bool> list(const std::vector<std::string>& items, int selected, const UiListOptions& options);
  // The text, and whether enter ended it in this tick.
  std::pair<std::string, bool> field(const std::string& label, const std::string& text, const UiFieldOptions& options);
  // Shows `names`; a raw name that was pressed after this was.
  std::optional<std::string> key(const std::string& label, const std::vector<std::string>& names, const UiWidgetOptions& options);
  // What follows stands in it, until close(). Returns how many were open, for close().
  int open_panel(const UiPanelOptions& options);
  int open_row();
  void close(int depth);
  // To that widget, if it is there at the end of this tick; "": to the first.
  void focus(const std::string& key);
  const std::string& focused() const { return focus_; }
  bool is_writing() const;             // is a field in focus?

  // ---- the screen of the last tick
  bool is_over() const { return over_; }    // the pointer, a widget or a panel that holds some
  // The place of a widget by label or id, or of a text by its words; nullptr where none is seen.
  const UiRect* find_widget(const std::string& label) const;
  bool is_on_screen(const std::string& label) const;
  std::vector<std::string> labels() const;

 private:
  // What happened to a widget in this tick's input.
  struct Happening {
    bool pressed = false;
    std::optional<double> dragged;     // a slider's pointer: 0 at its left end, 1 at the right
    int steps = 0;                     // a slider's or list's arrows
    int picked = 0;                    // a list's item, from 1
    std::string typed;                 // of a field; '\b' takes a letter away
    std::string key;                   // that a key widget was given
  };
  struct Place {                       // of the last screen
    UiKind kind;
    std::string key, label;
    UiRect rect, track;
    bool enabled, focusable;
    int items, first, shown, selected; // of a list
    double item_height;
  };

  // input.cpp
  bool take(const InputEvent& event);
  bool take_press(const std::string& raw);
  bool take_release(const std::string& raw);
  bool take_typing(const std::string& raw);
  bool press_pointer();
  void release_pointer();
  void move_pointer(double x, double y);
  void drag(const Place& slider);
  bool turn_wheel(double steps);
  bool go(UiDirection direction, bool again);
  void repeat(double tick_seconds);
  void press_list(const Place& list);
  const Place* place(const std::string& key) const;
  const Place* place_under_pointer() const;
  bool over_ui() const;
  // ui.cpp
  UiElement& add(UiKind kind, const UiPlace& place, const char* call);
  UiElement& add_widget(UiKind kind, const std::string& label, const UiWidgetOptions& options, const char* call);
  Happening* happening(const std::string& key);
  void keep_places(double screen_width);
  void keep_focus();
  void scroll_to_selected();
  // paint.cpp
  bool has_ground(const UiElement& e) const;
  void paint(std::vector<DrawUi>& out) const;
  void paint_element(const UiElement& e, std::vector<DrawUi>& out) const;
  void paint_widget(const UiElement& e, std::vector<DrawUi>& out) const;
  void paint_list(const UiElement& e, bool bright, std::vector<DrawUi>& out) const;

  UiStyle style_;
  bool open_ = false;
  UiElements elements_;                // of this tick
  std::vector<int> containers_;        // open columns and rows
  std::set<std::string> keys_;         // named in this tick

  std::vector<Place> places_;          // of the last tick, in drawing order
  std::vector<std::pair<std::string, UiRect>> texts_;
  std::vector<UiRect> solids_;         // panels that hold widgets
  std::map<std::string, Happening> happened_;

  std::string focus_, held_, hover_, waiting_;   // keys of widgets; waiting_: of the one that wants a key
  std::string focus_wanted_;
  std::map<std::string, int> first_shown_;       // of lists that are scrolled
  std::set<std::string> taken_;                  // raw names whose release is ours too
  std::string repeating_;                        // the raw name of an arrow that is held
  UiDirection repeating_direction_ = UiDirection::down;
  double repeat_seconds_ = 0;                    // until it counts again
  double pointer_x_ = 640, pointer_y_ = 360;
  double wheel_ = 0;                             // less than a step, so far
  bool pointer_used_ = false;                    // rather than keys, just now
  bool over_ = false;
  std::uint64_t ticks_ = 0;
};

}  // namespace tumble
