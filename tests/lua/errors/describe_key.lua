-- expect: input.describe: no key or button 'spcae'; did you mean 'space'?
function start() print(input.describe("spcae")) end
