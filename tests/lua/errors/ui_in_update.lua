-- expect: ui.text: only in draw_ui(), which says what is on the screen in each tick
function update() ui.text("hello") end
