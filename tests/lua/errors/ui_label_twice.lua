-- expect: ui.button: 'Play' is there twice in this tick; give one of them an id of its own: { id = "Play 2" }
function draw_ui() ui.button("Play") ui.button("Play") end
