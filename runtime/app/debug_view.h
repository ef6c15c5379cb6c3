// The debug view: what the physics knows, drawn over the picture (physics.debug_view, F3).
#pragma once

#include <vector>

#include "engine/engine.h"
#include "render/draw_list.h"
#include "script/script.h"

namespace tumble {

// Bodies stand where the picture shows them: between the last tick (alpha 0) and this one. `queries` are those of the
// scripts, `dropped_seconds` what the loop left out. The list's camera must be set.
void add_debug_view(DrawList& list, const Engine& engine, DebugView view, const std::vector<DebugQuery>& queries, double alpha,
                    double aspect, double dropped_seconds);

}  // namespace tumble
