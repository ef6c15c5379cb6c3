-- expect: setmetatable: __gc is not available: when memory is freed differs from run to run
setmetatable({}, { __gc = function() end })
