-- expect: scene.add: light.type: unknown 'spott'; expected one of sun, point, spot; did you mean 'spot'?
scene.add { light = "spott" }
