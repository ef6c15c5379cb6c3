-- expect: sound.play: no field 'volum'; did you mean 'volume'?
function start() sound.play("boom.wav", { volum = 1 }) end
