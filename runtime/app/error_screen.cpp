#include "app/error_screen.h"

#include <algorithm>

#include "render/renderer.h"

namespace tumble {

void add_panel(DrawList& list, double x, double y, double width, double height, const Color& color) {
  DrawUi entry;
  entry.panel = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width), static_cast<float>(height), color};
  list.ui.push_back(entry);
}

void add_text(DrawList& list, const std::string& text, double x, double y, double size, const Color& color, bool mono) {
  DrawUi entry;
  entry.is_text = true;
  entry.text = {text, static_cast<float>(x), static_cast<float>(y), static_cast<float>(size), color, mono};
  list.ui.push_back(entry);
}

namespace {

// Broken into lines that fit the width, at spaces where there are any.
std::vector<std::string> wrap(const std::string& text, double size, double width, bool mono) {
  std::vector<std::string> lines;
  std::string line;
  auto fits = [&](const std::string& t) { return measure_text(t, size, mono).width <= width; };
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && !fits(line + " " + word)) {
      lines.push_back(line);
      line = word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    if (end < text.size() && text[end] == '\n') {
      lines.push_back(line);
      line.clear();
    }
    begin = end + 1;
  }
  lines.push_back(line);
  return lines;
}

}  // namespace

void add_error_screen(DrawList& list, const ScriptFailure& failure, double aspect) {
  constexpr double margin = 40, size = 22;
  const double width = kUiHeight * aspect - 2 * margin;
  const std::vector<std::string> message = wrap(failure.text, size, width - 40, false);
  std::vector<std::string> trace = wrap(failure.traceback, 16, width - 40, true);
  if (trace.size() > 9) trace.resize(9);
  const double height = 40 + static_cast<double>(message.size()) * size + (failure.source.empty() ? 0 : 44) + static_cast<double>(trace.size()) * 16 + 56;
  double y = std::max(20.0, kUiHeight - margin - height);
  add_panel(list, margin, y, width, height, {0.12, 0.05, 0.06, 0.92});
  add_panel(list, margin, y, 6, height, {0.9, 0.25, 0.2, 1});
  y += 20;
  for (const std::string& line : message) {
    add_text(list, line, margin + 24, y, size, {1, 0.85, 0.8, 1});
    y += size;
  }
  if (!failure.source.empty()) {
    y += 10;
    std::string source = failure.source;
    source.erase(0, source.find_first_not_of(" \t"));
    add_text(list, std::to_string(failure.line) + " | " + source, margin + 24, y, 20, {1, 1, 1, 1}, true);
    y += 34;
  }
  for (const std::string& line : trace) {
    add_text(list, line, margin + 24, y, 16, {0.75, 0.7, 0.7, 1}, true);
    y += 16;
  }
  add_text(list, failure.in_text ? "The game goes on with the code from before. The next good save takes this away."
                                 : "What failed is stopped, the rest goes on. The next good save takes this away and tries again.", margin + 24, y + 12, 18, {0.8, 0.75, 0.72, 1});
}

void add_lines(DrawList& list, const std::vector<std::pair<std::string, Color>>& lines, double) {
  constexpr double size = 18;
  double y = kUiHeight - 16 - size * static_cast<double>(lines.size());
  for (const auto& [text, color] : lines) {
    const TextSize measure = measure_text(text, size);
    add_panel(list, 12, y, measure.width + 12, size, {0, 0, 0, 0.45});
    add_text(list, text, 18, y, size, color);
    y += size;
  }
}

void add_watches(DrawList& list, const std::vector<std::pair<std::string, std::string>>& watches, double aspect) {
  constexpr double size = 18, width = 260;
  double y = 90;
  const double x = kUiHeight * aspect - width - 12;
  for (const auto& [name, value] : watches) {
    add_panel(list, x, y, width, size, {0, 0, 0, 0.45});
    add_text(list, name, x + 6, y, size, {0.75, 0.85, 1, 1});
    add_text(list, value, x + width - 6 - measure_text(value, size, true).width, y, size, {1, 1, 1, 1}, true);
    y += size;
  }
}

}  // namespace tumble
