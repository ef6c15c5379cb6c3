-- expect: physics.raycast: argument 3 (length): number expected, got nil
function update(dt) physics.raycast(vec3.zero, vec3.down) end
