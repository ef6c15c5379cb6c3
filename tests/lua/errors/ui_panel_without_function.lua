-- expect: ui.panel: argument 2 (content): function expected, got nil
function draw_ui() ui.panel({ at = "center" }) end
