-- expect: physics.raycast: direction must not be zero (got 0, 0, 0); give a direction such as node.forward
function update(dt) physics.raycast(vec3.zero, vec3.zero, 10) end
