-- expect: unknown name 'sceen'; did you mean 'scene'?
sceen.add { name = "ball" }
