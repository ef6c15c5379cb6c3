-- expect: ui.text: no option 'colour'; did you mean 'color'?
function draw_ui() ui.text("hello", { colour = "red" }) end
