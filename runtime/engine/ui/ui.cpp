#include "engine/ui/ui.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "engine/ui/layout.h"

namespace tumble {

namespace {

constexpr double kGap = 10;            // of rows, and of what stands in a corner of its own

void check_text(const std::string& text, const char* call) {
  if (!is_utf8(text)) fail(call, ": the text is not UTF-8; save the file as UTF-8");
}

// As a person reads it: 80 % of 0 to 1, else as many digits as the steps have, at most two.
std::string slider_number(double value, const UiSliderOptions& o) {
  if (o.min == 0 && o.max == 1) return std::to_string(std::lround(value * 100)) + " %";
  const bool whole = o.step > 0 && o.step == std::floor(o.step) && o.min == std::floor(o.min);
  return number_text(whole ? std::round(value) : std::round(value * 100) / 100);
}

double stepped(double value, const UiSliderOptions& o) {
  if (o.step > 0) value = o.min + std::round((value - o.min) / o.step) * o.step;
  return std::clamp(value, o.min, o.max);
}

// "left_shift" -> "Left Shift".
std::string key_text(const std::string& raw) {
  std::string text;
  bool begins = true;
  for (const char c : raw) {
    text += c == '_' ? ' ' : begins && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    begins = c == '_';
  }
  return text;
}

std::size_t letter_count(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

void remove_letter(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

// ---- a tick's screen

void Ui::begin(const UiStyle& style) {
  style_ = style;
  elements_.assign(1, UiElement{});
  elements_[0].kind = UiKind::column;
  elements_[0].gap = kGap;
  containers_ = {0};
  keys_.clear();
  open_ = true;
}

void Ui::end(double screen_width, std::vector<DrawUi>& out) {
  open_ = false;
  lay_out_ui(elements_, screen_width);
  scroll_to_selected();
  keep_places(screen_width);
  keep_focus();
  paint(out);
}

UiElement& Ui::add(UiKind kind, const UiPlace& place, const char* call) {
  const int parent = containers_.back();
  if (place.is_given() && parent != 0)
    fail(call, ": at, x and y are for what stands on its own; in a panel or row things stack: leave them out, or call it outside of the panel");
  const auto index = static_cast<int>(elements_.size());
  elements_[static_cast<std::size_t>(parent)].children.push_back(index);
  UiElement& e = elements_.emplace_back();
  e.kind = kind;
  e.parent = parent;
  e.place = place;
  e.size = style_.size;
  e.text_color = style_.text;
  return e;
}

UiElement& Ui::add_widget(UiKind kind, const std::string& label, const UiWidgetOptions& options, const char* call) {
  check_text(label, call);
  const std::string key = options.id.value_or(label);
  if (key.empty()) fail(call, ": without a label it needs an id, such as id = \"names\"");
  if (!keys_.insert(key).second)
    fail(call, ": '", key, "' is there twice in this tick; give one of them an id of its own: { id = \"", key, " 2\" }");
  UiElement& e = add(kind, options, call);
  e.key = key;
  e.text = label;
  e.width = options.width;
  e.size = options.size.value_or(style_.size);
  e.color = options.color.value_or(Color{1, 1, 1, 0.1});
  e.text_color = options.text_color.value_or(style_.text);
  e.enabled = options.enabled;
  bool in_panel = false, keys = true;
  for (int c = e.parent; c >= 0; c = elements_[static_cast<std::size_t>(c)].parent) {
    UiElement& column = elements_[static_cast<std::size_t>(c)];
    column.has_widgets = true;
    in_panel |= column.visible;
    keys &= column.focusable || !column.visible;
  }
  e.focusable = options.focus.value_or(in_panel && keys);
  return e;
}

Ui::Happening* Ui::happening(const std::string& key) {
  const auto found = happened_.find(key);
  return found == happened_.end() ? nullptr : &found->second;
}

// ---- what is only seen

void Ui::text(const std::string& words, const UiTextOptions& options) {
  check_text(words, "ui.text");
  UiElement& e = add(UiKind::text, options, "ui.text");
  e.text = words;
  e.size = options.size.value_or(style_.size);
  e.color = options.color.value_or(style_.text);
  e.width = options.width;
  e.align = options.align;
}

void Ui::space(double amount) {
  UiElement& e = add(UiKind::space, {}, "ui.space");
  const bool in_row = elements_[static_cast<std::size_t>(e.parent)].kind == UiKind::row;
  e.width = in_row ? amount : 0;
  e.height = in_row ? 0 : amount;
}

void Ui::bar(double fraction, const UiBarOptions& options) {
  UiElement& e = add(UiKind::bar, options, "ui.bar");
  e.fraction = std::clamp(fraction, 0.0, 1.0);
  e.width = options.width;
  e.height = options.height;
  e.color = options.color.value_or(style_.accent);
}

void Ui::box(const UiBoxOptions& options) {
  UiElement& e = add(UiKind::box, options, "ui.box");
  e.width = options.width;
  e.height = options.height;
  e.radius = options.radius;
  e.color = options.color;
}

void Ui::image(const std::string& file, double natural_width, double natural_height, const UiImageOptions& options) {
  UiElement& e = add(UiKind::image, options, "ui.image");
  e.text = file;
  const double shape = natural_width / natural_height;
  e.width = options.width.value_or(options.height ? *options.height * shape : natural_width);
  e.height = options.height.value_or(*e.width / shape);
  e.color = options.color;
}

// ---- what can be used

bool Ui::button(const std::string& label, const UiWidgetOptions& options) {
  const UiElement& e = add_widget(UiKind::button, label, options, "ui.button");
  const Happening* what = happening(e.key);
  return what && what->pressed && e.enabled;
}

bool Ui::toggle(const std::string& label, bool on, const UiWidgetOptions& options) {
  UiElement& e = add_widget(UiKind::toggle, label, options, "ui.toggle");
  const Happening* what = happening(e.key);
  e.on = what && what->pressed && e.enabled ? !on : on;
  return e.on;
}

double Ui::slider(const std::string& label, double value, const UiSliderOptions& options) {
  UiElement& e = add_widget(UiKind::slider, label, options, "ui.slider");
  const double span = options.max - options.min;
  if (!(span > 0)) fail("ui.slider: max must be above min (got min ", number_text(options.min), ", max ", number_text(options.max), ")");
  if (const Happening* what = happening(e.key); what && e.enabled) {
    if (what->dragged) value = stepped(options.min + *what->dragged * span, options);
    if (what->steps != 0) value = stepped(value + what->steps * (options.step > 0 ? options.step : span / 20), options);
  }
  e.fraction = std::clamp((value - options.min) / span, 0.0, 1.0);
  e.value = slider_number(value, options);
  return value;
}

std::pair<int, bool> Ui::list(const std::vector<std::string>& items, int selected, const UiListOptions& options) {
  UiElement& e = add_widget(UiKind::list, "", options, "ui.list");
  for (const std::string& item : items) check_text(item, "ui.list");
  const auto count = static_cast<int>(items.size());
  const Happening* what = happening(e.key);
  if (what && e.enabled && what->steps != 0) selected = std::clamp(selected + what->steps, 1, count);
  if (what && e.enabled && what->picked != 0) selected = std::min(what->picked, count);
  e.items = items;
  e.selected = std::clamp(selected, 0, count);
  e.height = options.height;
  return {e.selected, what && e.enabled && what->pressed && e.selected > 0};
}

std::pair<std::string, bool> Ui::field(const std::string& label, const std::string& text, const UiFieldOptions& options) {
  check_text(text, "ui.field");
  UiElement& e = add_widget(UiKind::field, label, options, "ui.field");
  if (!options.focus) e.focusable = true;                 // it is there to be written into
  e.value = text;
  const Happening* what = happening(e.key);
  if (!what || !e.enabled) return {text, false};
  for (std::size_t i = 0; i < what->typed.size(); ++i) {
    const char c = what->typed[i];
    const bool begins = (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    if (c == '\b') remove_letter(e.value);
    else if (static_cast<unsigned char>(c) < 0x20) continue;
    else if (begins && letter_count(e.value) >= static_cast<std::size_t>(options.length)) break;
    else e.value += c;
  }
  return {e.value, what->pressed};
}

std::optional<std::string> Ui::key(const std::string& label, const std::vector<std::string>& names, const UiWidgetOptions& options) {
  UiElement& e = add_widget(UiKind::key, label, options, "ui.key");
  for (const std::string& name : names) e.value += (e.value.empty() ? "" : " / ") + key_text(name);
  if (e.key == waiting_) e.value = "press a key";
  const Happening* what = happening(e.key);
  if (!what || what->key.empty() || !e.enabled) return std::nullopt;
  return what->key;
}

// ---- panels and rows

int Ui::open_panel(const UiPanelOptions& options) {
  UiElement& e = add(UiKind::column, options, "ui.panel");
  e.width = options.width;
  e.height = options.height;
  // A panel in a panel is told from it without growing dark.
  bool inside = false;
  for (const int c : containers_) inside |= elements_[static_cast<std::size_t>(c)].visible;
  e.color = options.color.value_or(inside ? Color{1, 1, 1, 0.06} : style_.panel);
  e.align = options.align;
  e.padding = options.padding;
  e.gap = options.gap;
  e.radius = options.radius;
  e.visible = true;
  e.focusable = options.focus;
  containers_.push_back(static_cast<int>(elements_.size()) - 1);
  return static_cast<int>(containers_.size()) - 1;
}

int Ui::open_row() {
  UiElement& e = add(UiKind::row, {}, "ui.row");
  e.gap = kGap;
  containers_.push_back(static_cast<int>(elements_.size()) - 1);
  return static_cast<int>(containers_.size()) - 1;
}

void Ui::close(int depth) { containers_.resize(static_cast<std::size_t>(std::max(depth, 1))); }

// ---- what stays until the next tick

// Lists that the arrows moved in show what is selected.
void Ui::scroll_to_selected() {
  std::map<std::string, int> kept;
  for (UiElement& e : elements_) {
    if (e.kind != UiKind::list) continue;
    const int count = static_cast<int>(e.items.size()), shown = ui_shown_items(e);
    const auto before = first_shown_.find(e.key);
    int first = before == first_shown_.end() ? std::max(0, e.selected - shown) : before->second;
    if (const Happening* what = happening(e.key); what && what->steps != 0)
      first = std::clamp(first, e.selected - shown, e.selected - 1);
    e.first = std::clamp(first, 0, std::max(0, count - shown));
    kept[e.key] = e.first;
  }
  first_shown_ = std::move(kept);
}

void Ui::keep_places(double screen_width) {
  places_.clear();
  texts_.clear();
  solids_.clear();
  const UiRect screen{0, 0, screen_width, kUiHeight};
  for (const UiElement& e : elements_) {
    const bool seen = e.rect.x < screen.right() && e.rect.right() > 0 && e.rect.y < screen.bottom() && e.rect.bottom() > 0;
    if (e.kind == UiKind::text && seen) texts_.emplace_back(e.text, e.rect);
    if (e.kind == UiKind::column && e.visible && e.has_widgets) solids_.push_back(e.rect);
    if (!is_widget(e.kind)) continue;
    const UiRect track = e.kind == UiKind::slider ? ui_slider_track(e) : UiRect{};
    places_.push_back({e.kind, e.key, e.text, e.rect, track, e.enabled, e.focusable, static_cast<int>(e.items.size()), e.first,
                       e.kind == UiKind::list ? ui_shown_items(e) : 0, e.selected,
                       e.kind == UiKind::list ? ui_item_height(e) : 0});
  }
}

void Ui::focus(const std::string& key) {
  focus_.clear();
  focus_wanted_ = key;
}

// What is not drawn any more has no focus, is not held and waits for nothing. A menu begins with its first widget.
void Ui::keep_focus() {
  for (std::string* key : {&held_, &hover_, &waiting_})
    if (!place(*key)) key->clear();
  const auto can = [this](const std::string& key) {
    const Place* p = place(key);
    return p && p->enabled && p->focusable;
  };
  if (can(focus_wanted_)) focus_ = focus_wanted_;
  focus_wanted_.clear();
  if (can(focus_)) return;
  focus_.clear();
  const auto first = std::find_if(places_.begin(), places_.end(), [](const Place& p) { return p.enabled && p.focusable; });
  if (first != places_.end()) focus_ = first->key;
}

// ---- for bots

const UiRect* Ui::find_widget(const std::string& label) const {
  for (const Place& p : places_)
    if (p.key == label || p.label == label) return &p.rect;
  return nullptr;
}

bool Ui::is_on_screen(const std::string& label) const {
  return find_widget(label) || std::any_of(texts_.begin(), texts_.end(), [&](const auto& text) { return text.first == label; });
}

std::vector<std::string> Ui::labels() const {
  std::vector<std::string> list;
  for (const Place& p : places_) list.push_back(p.key);
  return list;
}

}  // namespace tumble
