-- expect: ui.key: no action 'jupm' in game.json
function draw_ui() ui.key("Jump", "jupm") end
