---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- A thing in the scene: a place, a name, and what hangs on it.
---@class node
---@field name string Its name; paths are names joined by '/'.
---@field id string Its lasting id, the same after saving and loading.
---@field path string The names from the top of the scene down to it.
---@field tags string[] Words to find it by: scene.tagged("coin").
---@field parent node? The node it hangs from; its place in the world is kept when it is hung elsewhere.
---@field children node[] Its children, to be read.
---@field visible boolean Is it drawn?
---@field enabled boolean Off: no drawing, no body, no updates, for its children too.
---@field is_alive boolean False once it was destroyed.
---@field position vec3 Relative to the parent, m. Written, it moves there; a dynamic body jumps.
---@field rotation quat Relative to the parent.
---@field rotation_degrees vec3 The same as Euler angles, turned first about y, then x, then z.
---@field scale vec3 Relative to the parent; each number above 0.
---@field world_position vec3 In the world, m.
---@field world_rotation quat In the world.
---@field forward vec3 Its -z direction in the world.
---@field right vec3 Its x direction in the world.
---@field up vec3 Its y direction in the world.
---@field color color|string The colour of its material.
---@field mesh mesh|shape_options|string What it looks like, or nil.
---@field material material|material_options|string How its surface looks.
---@field light light|light_options|string The light that shines from it, or nil.
---@field camera camera|camera_options The camera that looks from it, or nil.
---@field sky sky|sky_options|string The sky and fog that it brings, or nil.
---@field sound sound|sound_options|string What is heard from it, or nil.
---@field particles particles|particles_options|string The small sprites that rise from it, or nil.
---@field animation animation|animation_options|string The keyframes that move it, or nil.
---@field body body|body_options|string Its physical body, or nil.
---@field behaviours table Its behaviours by name: node.behaviours.slime.
---@field update? fun(dt: number) Each tick.
---@field on_collision_enter? fun(hit: hit) A body began to touch this one.
---@field on_collision_stay? fun(hit: hit) A body goes on touching this one; told only where a handler exists.
---@field on_collision_exit? fun(hit: hit) A body ceased to touch this one.
---@field on_trigger_enter? fun(hit: hit) A body came into this trigger, or this body into a trigger.
---@field on_trigger_stay? fun(hit: hit) It is still inside.
---@field on_trigger_exit? fun(hit: hit) It left.
---@field on_joint_break? fun(joint: joint) A joint of this body broke.
---@field on_animation_end? fun(clip: string) A clip that does not loop came to its end.
---@field on_sleep? fun() The body fell asleep.
---@field on_wake? fun() The body woke.
local node = {}

--- The descendant of that name or path; an error where there is none.
---@param path string
---@return node
function node:get(path) end

--- The descendant of that name or path, or nil.
---@param path string
---@return node?
function node:find(path) end

--- The joint of that name at this node, from either end, or nil.
---@param name string
---@return joint?
function node:joint(name) end

--- All joints at this node.
---@return joint[]
function node:joints() end

--- Does it have that tag?
---@param tag string
---@return boolean
function node:has_tag(tag) end

--- Calls on_<message> in this node's slot and behaviours, at once; true if anyone listened.
---@param message string
---@param ... any
---@return boolean
function node:send(message, ...) end

--- Moves it by an offset (times a factor), in its parent's space.
---@param offset vec3
---@param factor? number
---@overload fun(self: node, offset_x: number, offset_y: number, offset_z: number, factor?: number)
function node:translate(offset, factor) end

--- Turns it about one of its own axes.
---@param axis vec3
---@param radians number
---@overload fun(self: node, axis_x: number, axis_y: number, axis_z: number, radians: number)
function node:turn(axis, radians) end

--- Turns it so that its forward points at a point of the world.
---@param point vec3
---@overload fun(self: node, point_x: number, point_y: number, point_z: number)
function node:look_at(point) end

--- A point of its space in the world.
---@param point vec3
---@return vec3
---@overload fun(self: node, point_x: number, point_y: number, point_z: number): vec3
function node:to_world(point) end

--- A point of the world in its space.
---@param point vec3
---@return vec3
---@overload fun(self: node, point_x: number, point_y: number, point_z: number): vec3
function node:to_local(point) end

--- Jumps: nothing is drawn in between, contacts end, velocity stays.
---@param position vec3
---@param rotation? quat
---@overload fun(self: node, position_x: number, position_y: number, position_z: number, rotation?: quat)
function node:teleport(position, rotation) end

--- Ends it and its children at the end of the tick; is_alive is false at once.
function node:destroy() end

--- Its position as three numbers.
---@return number, number, number
function node:get_position() end

--- Sets its position.
---@param position vec3
---@overload fun(self: node, position_x: number, position_y: number, position_z: number)
function node:set_position(position) end

--- Its world position as three numbers.
---@return number, number, number
function node:get_world_position() end

--- Its scale as three numbers.
---@return number, number, number
function node:get_scale() end

--- A thing in the scene: where it is, what it is made of, what is below it.
---@class node_options
---@field name? string What paths and get() call it; nodes may share a name.
---@field id? string Lasting and unique in the scene; made where it is not given.
---@field tags? (string)[]|string Words to find it by.
---@field prefab? string Path of a scene file, without ending, that this node is a copy of; other keys override it field by field.
---@field position? vec3 Relative to the parent, m.
---@field rotation? quat Relative to the parent.
---@field rotation_degrees? vec3 The same in degrees.
---@field scale? vec3 Relative to the parent, for its children too.
---@field visible? boolean Off: it and its children are not drawn.
---@field enabled? boolean Off: no drawing, no body, no updates, for its children too.
---@field mesh? shape_options|string What is drawn, and what a body's collider is fitted to.
---@field material? material_options|string How the mesh looks.
---@field color? color|string Color of the material.
---@field light? light_options|string Makes it a light.
---@field camera? camera_options Makes it a camera.
---@field sky? sky_options|string Sky and fog around everything.
---@field sound? sound_options|string What is heard from it.
---@field particles? particles_options|string Small sprites that rise from it.
---@field animation? animation_options|string Keyframes that move it.
---@field body? body_options|string Makes it a rigid body.
---@field behaviours? table<string, any> Scripts by name, each with a table of its properties.
---@field joints? (any)[]|any In files: joints from this node, each a table with type, name, b and the options of joint.<type>.
---@field children? (node_options)[]|node_options Nodes below it.
---@field parent? node

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
