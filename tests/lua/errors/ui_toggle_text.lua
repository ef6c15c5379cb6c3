-- expect: ui.toggle: argument 2 (on): boolean expected, got "yes"
function draw_ui() ui.toggle("Sound", "yes") end
