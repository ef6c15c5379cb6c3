-- expect: parts/no_behaviour.lua does not return a behaviour; end it with `return` and the class
scene.add { behaviours = { ["parts/no_behaviour"] = {} } }
