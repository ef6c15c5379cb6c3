-- expect: sound.play: frame only draws
function frame() sound.play("boom.wav") end
