-- expect: ui.text: at: unknown 'middle'; expected one of top_left, top, top_right, left, center, right, bottom_left, bottom, bottom_right
function draw_ui() ui.text("hello", { at = "middle" }) end
