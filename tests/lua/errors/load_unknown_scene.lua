-- expect: no scene 'levels/one'
function start() scene.load("levels/one") end
