-- expect: this table's metatable is locked
setmetatable(scene, {})
