-- expect: filter has no field 'ignor'; did you mean 'ignore'?
function update(dt) physics.raycast(vec3.zero, vec3.down, 10, { ignor = scene.root }) end
