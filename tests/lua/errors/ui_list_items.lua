-- expect: ui.list: items[2]: a text or number expected, got a table
function draw_ui() ui.list({ "a", {} }, 1) end
