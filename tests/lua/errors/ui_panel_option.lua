-- expect: ui.panel: no option 'witdh'; did you mean 'width'?
function draw_ui() ui.panel({ witdh = 300 }, function() end) end
