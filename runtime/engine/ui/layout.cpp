#include "engine/ui/layout.h"

#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace tumble {

namespace {

constexpr double kMargin = 24;        // of the screen, around what is anchored
constexpr double kTrack = 220;        // a slider's or field's own part, where nothing says how wide it is
constexpr double kNumber = 2.8;       // of a slider's number, "100 %", in line heights

double item_height(double size) { return 1.4 * size; }

double text_width(const std::string& text, double size) { return text.empty() ? 0 : measure_text(text, size).width; }

// Right of a slider's track: its number, clear of the knob, which stands out by 0.375 lines at the track's end.
double number_room(const UiElement& slider) { return std::max(kNumber * slider.size, slider.value_width) + 0.65 * slider.size; }

// What takes a share of a row, or all of a column's width, unless it says how wide it is.
bool stretches(const UiElement& e) {
  if (e.width) return false;
  if (e.kind == UiKind::text) return e.align.has_value();
  return is_widget(e.kind) || e.kind == UiKind::bar || e.kind == UiKind::column;
}

struct Layout {
  UiElements& all;

  UiElement& at(int index) const { return all[static_cast<std::size_t>(index)]; }

  double widest_item(const UiElement& e) const {
    double widest = 0;
    for (const std::string& item : e.items) widest = std::max(widest, text_width(item, e.size));
    return widest;
  }

  // As wide as it needs.
  double natural_width(const UiElement& e) const {
    if (e.width) return *e.width;
    const double label = e.label_width, inset = ui_inset(e.size);
    switch (e.kind) {
      case UiKind::column: {
        double widest = 0;
        for (const int child : e.children) widest = std::max(widest, natural_width(at(child)));
        return widest + 2 * e.padding;
      }
      case UiKind::row: {
        double sum = e.gap * std::max(0.0, static_cast<double>(e.children.size()) - 1);
        for (const int child : e.children) sum += natural_width(at(child));
        return sum;
      }
      case UiKind::text: return label;
      case UiKind::space:
      case UiKind::image: return 0;
      case UiKind::bar:
      case UiKind::box: return 240;
      case UiKind::button: return label + 2 * inset;
      case UiKind::toggle: return label + inset + 1.4 * e.size + 2 * inset;
      case UiKind::slider: return label + inset + kTrack + number_room(e) + 2 * inset;
      case UiKind::list: return std::max(kTrack, widest_item(e) + 2 * inset + 2 * ui_list_padding);
      case UiKind::field: return label + inset + kTrack + 2 * inset;
      case UiKind::key: return label + 2 * inset + e.value_width + 2 * inset;
    }
    return 0;
  }

  double lines_height(const UiElement& e, double width) const {
    if (e.label_width <= width) return measure_text(e.text, e.size).height;
    return measure_text(wrap_text(e.text, e.size, width), e.size).height;
  }

  double inner_width(const UiElement& e, double width) const { return std::max(0.0, width - 2 * e.padding); }

  // A child of a column: all of its width, or as wide as it is.
  double width_in_column(const UiElement& e, double width) const {
    const bool fills = stretches(e) || e.kind == UiKind::row || e.kind == UiKind::text;
    return fills && !e.width ? width : std::min(natural_width(e), width);
  }

  double height_for(const UiElement& e, double width) const {
    if (e.height) return *e.height;
    switch (e.kind) {
      case UiKind::column: {
        double sum = 2 * e.padding + e.gap * std::max(0.0, static_cast<double>(e.children.size()) - 1);
        for (const int child : e.children) {
          const UiElement& c = at(child);
          sum += height_for(c, width_in_column(c, inner_width(e, width)));
        }
        return sum;
      }
      case UiKind::row: {
        const std::vector<double> widths = row_widths(e, width);
        double highest = 0;
        for (std::size_t i = 0; i < e.children.size(); ++i)
          highest = std::max(highest, height_for(at(e.children[i]), widths[i]));
        return highest;
      }
      case UiKind::text: return lines_height(e, e.width.value_or(width));
      case UiKind::list: return item_height(e.size) * static_cast<double>(std::max<std::size_t>(1, e.items.size())) + 2 * ui_list_padding;
      case UiKind::button:
      case UiKind::slider:
      case UiKind::toggle:
      case UiKind::field:
      case UiKind::key: return ui_row_height(e.size);
      default: return 0;
    }
  }

  // How much narrower it may become where room is short: tracks and bars do with less.
  static double spare_width(const UiElement& e) {
    if (e.kind == UiKind::slider || e.kind == UiKind::field) return kTrack - 60;
    return e.kind == UiKind::bar ? 220 : 0;
  }

  // What stretches shares what is left in equal parts, each at least as wide as it needs.
  std::vector<double> row_widths(const UiElement& row, double width) const {
    std::vector<double> widths;
    double left = width - row.gap * std::max(0.0, static_cast<double>(row.children.size()) - 1);
    int sharing = 0;
    for (const int child : row.children) {
      const UiElement& c = at(child);
      widths.push_back(natural_width(c) - (stretches(c) ? spare_width(c) : 0));
      if (stretches(c)) ++sharing;
      else left -= widths.back();
    }
    if (sharing == 0) return widths;
    double needed = 0;
    bool fits = true;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      if (!stretches(at(row.children[i]))) continue;
      needed += widths[i];
      fits = fits && widths[i] <= left / sharing;
    }
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (stretches(at(row.children[i])))
        widths[i] = fits ? left / sharing : widths[i] + std::max(0.0, left - needed) / sharing;
    return widths;
  }

  void place(UiElement& e, UiRect rect) {
    e.rect = rect;
    if (e.kind == UiKind::column) place_column(e);
    if (e.kind == UiKind::row) place_row(e);
  }

  static double aligned(UiAlign align, double free) {
    return align == UiAlign::left ? 0 : align == UiAlign::center ? free / 2 : free;
  }

  void place_column(UiElement& column) {
    const double inner = inner_width(column, column.rect.width);
    double y = column.rect.y + column.padding;
    for (const int child : column.children) {
      UiElement& c = at(child);
      if (!c.align && c.kind == UiKind::text) c.align = column.align.value_or(UiAlign::left);
      const double width = width_in_column(c, inner), height = height_for(c, width);
      place(c, {column.rect.x + column.padding + aligned(column.align.value_or(UiAlign::left), inner - width), y, width, height});
      y += height + column.gap;
    }
  }

  void place_row(UiElement& row) {
    const std::vector<double> widths = row_widths(row, row.rect.width);
    double used = row.gap * std::max(0.0, static_cast<double>(widths.size()) - 1);
    for (const double width : widths) used += width;
    double x = row.rect.x + aligned(at(row.parent).align.value_or(UiAlign::left), row.rect.width - used);
    for (std::size_t i = 0; i < row.children.size(); ++i) {
      UiElement& c = at(row.children[i]);
      const double height = height_for(c, widths[i]);
      place(c, {x, row.rect.y + (row.rect.height - height) / 2, widths[i], height});
      x += widths[i] + row.gap;
    }
  }
};

UiRect anchored(const UiPlace& place, double width, double height, double screen_width) {
  const double x = place.x.value_or(0), y = place.y.value_or(0);
  if (!place.at) return {x, y, width, height};
  const auto i = static_cast<int>(*place.at);
  const double xs[] = {kMargin, (screen_width - width) / 2, screen_width - width - kMargin};
  const double ys[] = {kMargin, (kUiHeight - height) / 2, kUiHeight - height - kMargin};
  return {xs[i % 3] + x, ys[i / 3] + y, width, height};
}

// One word that is too wide for a line: as many letters as fit, then the next line.
void break_word(std::string_view word, double size, double width, std::string& out, double& x) {
  for (std::size_t begin = 0; begin < word.size();) {
    std::size_t end = begin + 1;
    while (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0) == 0x80) ++end;   // a letter's other bytes
    const std::string letter(word.substr(begin, end - begin));
    const double wide = text_width(letter, size);
    if (x > 0 && x + wide > width) {
      out += '\n';
      x = 0;
    }
    out += letter;
    x += wide;
    begin = end;
  }
}

}  // namespace

void lay_out_ui(UiElements& elements, double width) {
  for (UiElement& e : elements) {
    e.label_width = e.kind == UiKind::image ? 0 : text_width(e.text, e.size);
    e.value_width = text_width(e.value, e.size);
  }
  Layout layout{elements};
  double y = kMargin;                 // of what stands nowhere in particular: below what came before
  for (const int child : elements[0].children) {
    UiElement& e = elements[static_cast<std::size_t>(child)];
    const double wide = e.width ? *e.width : std::min(layout.natural_width(e), width - 2 * kMargin), high = layout.height_for(e, wide);
    if (e.place.is_given()) {
      layout.place(e, anchored(e.place, wide, high, width));
      continue;
    }
    layout.place(e, {kMargin, y, wide, high});
    y += high + elements[0].gap;
  }
}

UiRect ui_slider_track(const UiElement& slider) {
  const double inset = ui_inset(slider.size), number = number_room(slider);
  const double label = slider.text.empty() ? 0 : slider.label_width + inset;
  const double room = slider.rect.width - 2 * inset - number;
  const double width = std::max(20.0, std::min(room - label, 0.6 * room));   // so that those of a menu stand in line
  return {slider.rect.right() - inset - number - width, slider.rect.y, width, slider.rect.height};
}

int ui_shown_items(const UiElement& list) {
  return std::max(1, static_cast<int>((list.rect.height - 2 * ui_list_padding + 1e-6) / item_height(list.size)));
}

double ui_item_height(const UiElement& list) {
  const int shown = ui_shown_items(list);
  return static_cast<int>(list.items.size()) > shown ? (list.rect.height - 2 * ui_list_padding) / shown : item_height(list.size);
}

std::string wrap_text(const std::string& text, double size, double width) {
  // A line that is exactly as wide as its room must not break for a rounding's sake.
  const double room = width + 0.01;
  if (measure_text(text, size).width <= room) return text;
  const double space = text_width(" ", size);
  std::string out;
  double x = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const double wide = text_width(word, size);
    if (x > 0 && x + space + wide > room) {
      out += '\n';
      x = 0;
    } else if (x > 0) {
      out += ' ';
      x += space;
    }
    if (wide > room) break_word(word, size, room, out, x);
    else out += word, x += wide;
    if (end < text.size() && text[end] == '\n') {
      out += '\n';
      x = 0;
    }
    begin = end + 1;
  }
  return out;
}

}  // namespace tumble
