-- expect: ui.slider: max must be above min (got min 5, max 2)
function draw_ui() ui.slider("Lives", 3, { min = 5, max = 2 }) end
