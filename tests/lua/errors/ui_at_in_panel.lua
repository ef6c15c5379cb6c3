-- expect: ui.text: at, x and y are for what stands on its own; in a panel or row things stack
function draw_ui() ui.panel({ at = "center" }, function() ui.text("hello", { at = "top" }) end) end
