-- expect: ui.text: at: one of top_left, top, top_right, left, center, right, bottom_left, bottom, bottom_right expected
function draw_ui() ui.text("hello", { at = "middle" }) end
