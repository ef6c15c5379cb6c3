-- expect: ui.button: without a label it needs an id
function draw_ui() ui.button("") end
