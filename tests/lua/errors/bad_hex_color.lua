-- expect: scene.add: color: '#12' is not a color; write #rgb, #rrggbb or #rrggbbaa
scene.add { color = "#12" }
