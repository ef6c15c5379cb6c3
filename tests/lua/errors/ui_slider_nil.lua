-- expect: ui.slider: argument 2 (value): number expected, got nil
function draw_ui() ui.slider("Volume") end
