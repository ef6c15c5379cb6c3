---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- Joints between two bodies, or a body and the world.
---@class joint_module
joint = {}

--- Welds two bodies.
---@param options joint_options
---@return joint
function joint.fixed(options) end

--- Lets a turn about an axis (a revolute joint).
---@param options hinge_options
---@return joint
function joint.hinge(options) end

--- Lets a slide along an axis (a prismatic joint).
---@param options slider_options
---@return joint
function joint.slider(options) end

--- Lets a slide along an axis and turn about it.
---@param options cylindrical_options
---@return joint
function joint.cylindrical(options) end

--- Lets a turn freely about a point (a spherical joint).
---@param options ball_options
---@return joint
function joint.ball(options) end

--- Lets a turn about two axes across each other (Hooke's joint).
---@param options universal_options
---@return joint
function joint.universal(options) end

--- Lets a bone swing within a cone and twist (a cone-twist joint).
---@param options ragdoll_options
---@return joint
function joint.ragdoll(options) end

--- A joint: its options can be read and written live.
---@class joint: hinge_options, slider_options, cylindrical_options, universal_options, ragdoll_options
---@field type string "fixed", "hinge", "slider", "cylindrical", "ball", "universal" or "ragdoll".
---@field name string The name it is found by: node:joint(name).
---@field a node The first node; anchor and axis are in its space.
---@field b node? The second node, or nil for the world.
---@field angle number Of a hinge: how far a has turned against b since it was made, rad.
---@field angle_degrees number The same in degrees.
---@field position number Of a slider: how far a has slid against b since it was made, m.
---@field speed number Of a hinge or slider: how fast that changes, rad/s or m/s.
---@field force vec3 What it pushed a with in the last tick, N.
---@field torque vec3 What it twisted a with in the last tick, N m.
---@field is_broken boolean Has it broken?
local joint = {}

--- Frees the bodies.
function joint:destroy() end

--- Ties two bodies together. Anchor and axis are in the first one's frame.
---@class joint_options
---@field anchor? vec3 Where it is, in a's frame, m.
---@field axis? vec3 Its direction, in a's frame; any length but zero.
---@field break_force? number Breaks where it holds with more than this, N.
---@field break_torque? number Breaks where it holds with more than this, N m.
---@field collide_connected? boolean Do its two bodies collide with each other?
---@field enabled? boolean Off: it holds nothing.
---@field name? string
---@field a? node
---@field b? node
---@field world_anchor? vec3
---@field world_axis? vec3

--- Welds two bodies together (a weld).
---@class fixed_options: joint_options

--- Lets two bodies turn about one axis, as a door on its frame (a revolute joint).
---@class hinge_options: joint_options
---@field min? number Lower limit; none where it is not given.
---@field min_degrees? number The same in degrees.
---@field max? number Upper limit; equal limits lock. More than one turn is allowed.
---@field max_degrees? number The same in degrees.
---@field motor? turn_motor_options Drives it.
---@field spring? turn_spring_options Pulls it back.
---@field friction? number Brakes it with up to this torque, N m.

--- Drives a turning freedom at a speed or towards a target.
---@class turn_motor_options
---@field speed? number rad/s; with a target, the most it uses on the way.
---@field target? number Angle to go to and hold.
---@field target_degrees? number The same in degrees.
---@field torque? number The most it turns with, N m; unlimited where it is not given.

--- Pulls a turning freedom to its rest.
---@class turn_spring_options
---@field frequency? number How often it would swing in a second, Hz; 0 is no spring.
---@field damping? number Ratio: 0 swings on, 1 comes to rest without swinging over.
---@field rest? number Where it pulls to.
---@field rest_degrees? number The same in degrees.

--- Lets two bodies slide along one axis, as a drawer (a prismatic joint).
---@class slider_options: joint_options
---@field min? number Lower limit, m; none where it is not given.
---@field max? number Upper limit, m; equal limits lock.
---@field motor? slide_motor_options Drives it.
---@field spring? slide_spring_options Pulls it back.
---@field friction? number Brakes it with up to this force, N.

--- Drives a sliding freedom at a speed or towards a target.
---@class slide_motor_options
---@field speed? number m/s; with a target, the most it uses on the way.
---@field target? number Position to go to and hold, m.
---@field force? number The most it pushes, N; unlimited where it is not given.

--- Pulls a sliding freedom to its rest.
---@class slide_spring_options
---@field frequency? number How often it would swing in a second, Hz; 0 is no spring.
---@field damping? number Ratio: 0 swings on, 1 comes to rest without swinging over.
---@field rest? number Where it pulls to, m.

--- Lets two bodies slide along one axis and turn about it, as a ring on a rod.
---@class cylindrical_options: joint_options
---@field slide? slide_options Along the axis.
---@field turn? turn_options About the axis.

--- Moving along an axis; 0 is the pose at creation.
---@class slide_options
---@field min? number Lower limit, m; none where it is not given.
---@field max? number Upper limit, m; equal limits lock.
---@field motor? slide_motor_options Drives it.
---@field spring? slide_spring_options Pulls it back.
---@field friction? number Brakes it with up to this force, N.
---@field position? number Where it is, m; to be read.
---@field speed? number How fast that changes, m/s; to be read.

--- Turning about an axis, right-handed; 0 is the pose at creation.
---@class turn_options
---@field min? number Lower limit; none where it is not given.
---@field min_degrees? number The same in degrees.
---@field max? number Upper limit; equal limits lock. More than one turn is allowed.
---@field max_degrees? number The same in degrees.
---@field motor? turn_motor_options Drives it.
---@field spring? turn_spring_options Pulls it back.
---@field friction? number Brakes it with up to this torque, N m.
---@field angle? number Where it is, rad; to be read.
---@field angle_degrees? number The same in degrees.
---@field speed? number How fast that changes, rad/s; to be read.

--- Keeps two bodies together at one point; they turn freely (a spherical joint).
---@class ball_options: joint_options
---@field friction? number Brakes the turning with up to this torque about each axis, N m.

--- Lets two bodies turn about two axes across each other, as two shafts joined by a cross (Hooke's joint).
---@class universal_options: joint_options
---@field axis_b? vec3 The second axis, which b carries, in a's frame as the joint is made; the part of it across `axis` counts. Some direction across `axis` where it is not given.
---@field turn_a? turn_options About `axis`, which a carries.
---@field turn_b? turn_options About `axis_b`.

--- Lets a bone swing within a cone and twist about its axis, as a shoulder (a cone-twist joint). With both swings limited the cone is elliptic. Swings of near half a turn cannot be told from twists: keep limits below 170 degrees.
---@class ragdoll_options: joint_options
---@field swing_axis? vec3 What `swing_a` is about, in a's frame as the joint is made; the part of it across `axis` counts. Some direction across `axis` where it is not given.
---@field swing_a? swing_options About `swing_axis`.
---@field swing_b? swing_options About the direction across `axis` and `swing_axis`.
---@field twist? turn_options About `axis`.

--- Swinging about a direction across the axis, to both sides alike; 0 is the pose at creation.
---@class swing_options
---@field max? number How far, to both sides; 0 locks. None where it is not given.
---@field max_degrees? number The same in degrees.
---@field motor? turn_motor_options Drives it.
---@field spring? turn_spring_options Pulls it back.
---@field friction? number Brakes it with up to this torque, N m.
---@field angle? number Where it is, rad; to be read.
---@field angle_degrees? number The same in degrees.
---@field speed? number How fast that changes, rad/s; to be read.
