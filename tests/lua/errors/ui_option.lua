-- expect: ui.text: no option 'colour'
function draw_ui() ui.text("hello", { colour = "red" }) end
