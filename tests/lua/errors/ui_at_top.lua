-- expect: ui.button: only in draw_ui()
ui.button("Play")
