-- expect: unknown 'spere'; expected one of
scene.add { mesh = "spere" }
