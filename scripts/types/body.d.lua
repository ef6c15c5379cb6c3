---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What makes a node a physical body: node.body.
---@class body
---@field node node The node that it moves.
---@field velocity vec3 Of the centre of mass in the world, m/s.
---@field angular_velocity vec3 In the world, rad/s.
---@field mass number Mass, kg; 0 is read of a static or kinematic body.
---@field is_asleep boolean Is it at rest and left out of the simulation until something touches it?
---@field momentum vec3 Mass times velocity, kg m/s.
---@field kinetic_energy number Of its motion and its spin, J.
---@field inertia vec3 Principal moments of inertia, kg m^2; nil gives them back to the colliders.
---@field center_of_mass vec3 In the body's frame, m; nil gives it back to the colliders.
---@field type "dynamic"|"static"|"kinematic" "dynamic" obeys forces, "static" never moves, "kinematic" is moved by you and pushes dynamic ones.
---@field fit "mesh"|"node" Where no colliders are given: fitted to the "mesh", or a box of the "node"'s scale.
---@field density? number Instead of a mass, kg/m^3.
---@field damping number 1/s: a free body's speed is v0 exp(-damping t).
---@field angular_damping number The same for turning, 1/s.
---@field gravity_factor number How much of the world's gravity pulls at it; 0 floats, -1 rises.
---@field rotation_factor vec3 How readily it turns about the world's x, y and z; 0 locks.
---@field lock_position string World axes along which it cannot move: "z", "xyz".
---@field lock_rotation string World axes about which it cannot turn: "xz", "xyz".
---@field friction? number Coulomb's coefficient; physics.default_friction where it is not given.
---@field restitution? number Speed after a hit over speed before; above 1 adds energy. physics.default_restitution where it is not given.
---@field rolling_friction number What stops a round body that rolls: a force at its rim of so many times what presses; on a slope steeper than this it rolls. 0.002 is a steel ball on steel, 0.03 a ball on grass. Of two bodies the larger counts.
---@field spinning_friction number The same for a round body that spins on the spot: a moment of so many times its radius times what presses.
---@field friction_combine? "average"|"min"|"max"|"multiply" How the frictions of two bodies become one. Where two bodies differ: multiply before average, before min, before max (the later one wins). The world's rule where neither says.
---@field restitution_combine? "average"|"min"|"max"|"multiply" The same for restitution.
---@field surface_velocity vec3 Of its surface against itself, in its own frame, as of a conveyor belt, m/s.
---@field group string A name from physics.groups; empty is the default group.
---@field collides_with (string)[]|string Names of the groups it meets; empty: all. "default" is the default group. Two bodies meet if both agree.
---@field trigger boolean Reports what is in it and lets everything through.
---@field continuous? boolean Met ahead on its whole way in a tick, so that it cannot pass through thin things, which is so where it is not given; false: only within its own size.
---@field can_sleep boolean May it fall asleep where it rests?
---@field colliders (collider_options|string)[]|collider_options|string Its shapes; fitted where none is given.
local body = {}

--- The velocity of the body's point at a place in the world, m/s.
---@param point vec3
---@return vec3
---@overload fun(self: body, point_x: number, point_y: number, point_z: number): vec3
function body:velocity_at(point) end

--- Pushes for this tick, N, at the centre of mass or at a point of the world. Give it every tick.
---@param force vec3
---@param point? vec3
---@overload fun(self: body, force_x: number, force_y: number, force_z: number, point?: vec3)
function body:apply_force(force, point) end

--- Twists for this tick, N m.
---@param torque vec3
---@overload fun(self: body, torque_x: number, torque_y: number, torque_z: number)
function body:apply_torque(torque) end

--- Kicks once, N s, at the centre of mass or at a point of the world.
---@param impulse vec3
---@param point? vec3
---@overload fun(self: body, impulse_x: number, impulse_y: number, impulse_z: number, point?: vec3)
function body:apply_impulse(impulse, point) end

--- Spins once, N m s.
---@param impulse vec3
---@overload fun(self: body, impulse_x: number, impulse_y: number, impulse_z: number)
function body:apply_angular_impulse(impulse) end

--- Puts it to sleep until something wakes it.
function body:sleep() end

--- Wakes it.
function body:wake() end

--- What touches it now.
---@return hit[]
function body:contacts() end

--- The nodes in its triggers, or whose triggers it is in.
---@return node[]
function body:overlapping() end

--- Adds a shape to it.
---@param collider collider_options
function body:add_collider(collider) end

--- Its velocity as three numbers.
---@return number, number, number
function body:get_velocity() end

--- Sets its velocity.
---@param velocity vec3
---@overload fun(self: body, velocity_x: number, velocity_y: number, velocity_z: number)
function body:set_velocity(velocity) end

--- Its angular velocity as three numbers.
---@return number, number, number
function body:get_angular_velocity() end

--- Sets its angular velocity.
---@param velocity vec3
---@overload fun(self: body, velocity_x: number, velocity_y: number, velocity_z: number)
function body:set_angular_velocity(velocity) end

--- Makes a node a rigid body.
---@class body_options
---@field type? "dynamic"|"static"|"kinematic" "dynamic" obeys forces, "static" never moves, "kinematic" is moved by you and pushes dynamic ones.
---@field fit? "mesh"|"node" Where no colliders are given: fitted to the "mesh", or a box of the "node"'s scale.
---@field mass? number Mass, kg; 1 where neither mass nor density is given.
---@field density? number Instead of a mass, kg/m^3.
---@field center_of_mass? vec3 In the body's frame, m; by its colliders where it is not given.
---@field inertia? vec3 Moments of inertia about the body's own axes through its centre of mass, kg m^2; by its colliders where they are not given. A thin hollow ball has 2/3 m r^2 about each.
---@field velocity? vec3 Of the centre of mass, world, m/s.
---@field angular_velocity? vec3 World, rad/s, right-handed about its direction.
---@field damping? number 1/s: a free body's speed is v0 exp(-damping t).
---@field angular_damping? number The same for turning, 1/s.
---@field gravity_factor? number How much of the world's gravity pulls at it; 0 floats, -1 rises.
---@field rotation_factor? vec3 How readily it turns about the world's x, y and z; 0 locks.
---@field lock_position? string World axes along which it cannot move: "z", "xyz".
---@field lock_rotation? string World axes about which it cannot turn: "xz", "xyz".
---@field friction? number Coulomb's coefficient; physics.default_friction where it is not given.
---@field restitution? number Speed after a hit over speed before; above 1 adds energy. physics.default_restitution where it is not given.
---@field rolling_friction? number What stops a round body that rolls: a force at its rim of so many times what presses; on a slope steeper than this it rolls. 0.002 is a steel ball on steel, 0.03 a ball on grass. Of two bodies the larger counts.
---@field spinning_friction? number The same for a round body that spins on the spot: a moment of so many times its radius times what presses.
---@field friction_combine? "average"|"min"|"max"|"multiply" How the frictions of two bodies become one. Where two bodies differ: multiply before average, before min, before max (the later one wins). The world's rule where neither says.
---@field restitution_combine? "average"|"min"|"max"|"multiply" The same for restitution.
---@field surface_velocity? vec3 Of its surface against itself, in its own frame, as of a conveyor belt, m/s.
---@field group? string A name from physics.groups; empty is the default group.
---@field collides_with? (string)[]|string Names of the groups it meets; empty: all. "default" is the default group. Two bodies meet if both agree.
---@field trigger? boolean Reports what is in it and lets everything through.
---@field continuous? boolean Met ahead on its whole way in a tick, so that it cannot pass through thin things, which is so where it is not given; false: only within its own size.
---@field can_sleep? boolean May it fall asleep where it rests?
---@field colliders? (collider_options|string)[]|collider_options|string Its shapes; fitted where none is given.

--- One shape of a body. What it leaves open holds as the body says.
---@class collider_options
---@field shape? "box"|"sphere"|"capsule"|"cylinder"|"cone"|"pyramid"|"plane"|"torus"|"hull"|"mesh"|"height_field" Which shape; it reads only the fields that are its own.
---@field size? vec3 Edge lengths of a box, a pyramid, a plane (x and z) or a height field, m; a model has its own.
---@field radius? number Of a sphere, capsule, cylinder, cone; of a torus, from the centre to the middle of its tube, m.
---@field height? number Of a capsule, cylinder or cone over all, rounded ends included, m.
---@field thickness? number Of a torus: the diameter of its tube, m.
---@field file? string The glTF model of a mesh or hull (.glb, .gltf), or the picture whose brightness is a height field; with nothing but a file the shape is a mesh.
---@field points? (vec3)[]|vec3 Corner points of a hull, m.
---@field offset? vec3 Where its centre is in the body's frame, m.
---@field rotation? quat How it is turned in the body's frame.
---@field rotation_degrees? vec3 The same in degrees.
---@field friction? number Instead of the body's.
---@field restitution? number Instead of the body's.
---@field density? number Instead of the body's, kg/m^3; where the body has a mass, only its ratio to the others' counts.
---@field trigger? boolean Instead of the body's: reports what is in it and lets everything through; it has no mass.
---@field name? string To find it again.
