-- expect: ui.button: width must be above 0 (got 0)
function draw_ui() ui.button("Play", { width = 0 }) end
