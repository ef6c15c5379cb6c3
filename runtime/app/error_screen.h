// What is drawn over a game for its author: the last failure, log lines, watched values.
#pragma once

#include <string>
#include <vector>

#include "engine/ui/options.h"
#include "render/draw_list.h"
#include "script/script.h"

namespace tumble {

void add_panel(DrawList& list, double x, double y, double width, double height, const Color& color);
void add_text(DrawList& list, const std::string& text, double x, double y, double size, const Color& color, bool mono = false);
// The failure with its place, source line and traceback, until the next good save clears it. The game stays visible.
void add_error_screen(DrawList& list, const ScriptFailure& failure, double aspect);
// Lines from the bottom left upwards, the newest last.
void add_lines(DrawList& list, const std::vector<std::pair<std::string, Color>>& lines, double aspect);
void add_watches(DrawList& list, const std::vector<std::pair<std::string, std::string>>& watches, double aspect);

}  // namespace tumble
