---@meta
-- Written by `tumble docs` from the table behind the bindings; change it there.

--- What a node looks like: node.mesh.
---@class mesh
---@field shape "box"|"sphere"|"capsule"|"cylinder"|"cone"|"pyramid"|"plane"|"torus"|"hull"|"mesh"|"height_field" Which shape; it reads only the fields that are its own.
---@field size vec3 Edge lengths of a box, a pyramid, a plane (x and z) or a height field, m; a model has its own.
---@field radius number Of a sphere, capsule, cylinder, cone; of a torus, from the centre to the middle of its tube, m.
---@field height number Of a capsule, cylinder or cone over all, rounded ends included, m.
---@field thickness number Of a torus: the diameter of its tube, m.
---@field file string The glTF model of a mesh or hull (.glb, .gltf), or the picture whose brightness is a height field; with nothing but a file the shape is a mesh.
---@field points (vec3)[]|vec3 Corner points of a hull, m.
local mesh = {}

--- A shape for a mesh, a collider, a cast or a drawing; axis y, centred, 1 m by default.
---@class shape_options
---@field shape? "box"|"sphere"|"capsule"|"cylinder"|"cone"|"pyramid"|"plane"|"torus"|"hull"|"mesh"|"height_field" Which shape; it reads only the fields that are its own.
---@field size? vec3 Edge lengths of a box, a pyramid, a plane (x and z) or a height field, m; a model has its own.
---@field radius? number Of a sphere, capsule, cylinder, cone; of a torus, from the centre to the middle of its tube, m.
---@field height? number Of a capsule, cylinder or cone over all, rounded ends included, m.
---@field thickness? number Of a torus: the diameter of its tube, m.
---@field file? string The glTF model of a mesh or hull (.glb, .gltf), or the picture whose brightness is a height field; with nothing but a file the shape is a mesh.
---@field points? (vec3)[]|vec3 Corner points of a hull, m.
