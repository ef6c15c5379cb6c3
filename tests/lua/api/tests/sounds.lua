-- Sounds by the game's time: tone.wav lasts half a second. Nothing is heard in tests, and all is as if it were.
local tick = 1 / 60
local tone = "sounds/tone.wav"

-- How long something stays true, s.
local function lasts(condition)
  local begun = time.now
  wait_until(function() return not condition() end, 10)
  return time.now - begun
end

test("a sound plays for its file's length", function()
  local voice = sound.play(tone)
  expect(voice.is_playing):equals(true)
  expect(lasts(function() return voice.is_playing end)):near(0.5, 2 * tick)
end)

test("an octave higher it lasts half as long", function()
  local voice = sound.play(tone, { pitch = 2 })
  expect(lasts(function() return voice.is_playing end)):near(0.25, 2 * tick)
end)

test("volume and pitch can be read and written, also when it is over", function()
  local voice = sound.play(tone, { volume = 0.5 })
  expect(voice.volume):equals(0.5)
  voice.volume, voice.pitch = 0.25, 10
  wait(0.2)
  expect(voice.is_playing):equals(false)
  voice.volume = 0.75
  expect(voice.volume):equals(0.75)
  voice:stop()
end)

test("a loop goes on until it is stopped", function()
  local voice = sound.play(tone, { loop = true })
  wait(2)
  expect(voice.is_playing):equals(true)
  voice:stop(0.5)
  expect(voice.is_playing):equals(false)
end)

test("a loop at a node ends with the node, another sound does not", function()
  local node = scene.add {}
  local loop, once = sound.play(tone, { at = node, loop = true }), sound.play(tone, { at = node })
  node:destroy()
  wait(0.1)
  expect(loop.is_playing):equals(false)
  expect(once.is_playing):equals(true)
end)

test("a missing file is silent and over at once", function()
  local voice = sound.play("sounds/none.wav")
  wait(2 * tick)
  expect(voice.is_playing):equals(false)
end)

test("a node's sound plays when it is told to, and says when it is over", function()
  local node = scene.add { sound = tone }
  expect(node.sound.file):equals(tone)
  expect(node.sound.playing):equals(false)
  node.sound:play()
  expect(node.sound.playing):equals(true)
  expect(lasts(function() return node.sound.playing end)):near(0.5, 3 * tick)
end)

test("play begins a node's sound anew, stop ends it", function()
  local node = scene.add { sound = { file = tone, playing = true } }
  wait(0.3)
  node.sound:play()
  wait(0.3)
  expect(node.sound.playing):equals(true)
  node.sound:stop()
  expect(node.sound.playing):equals(false)
end)

test("a node that is not enabled holds its sound", function()
  local node = scene.add { sound = { file = tone, playing = true } }
  wait(0.2)
  node.enabled = false
  wait(2)
  expect(node.sound.playing):equals(true)
  node.enabled = true
  expect(lasts(function() return node.sound.playing end)):near(0.3, 4 * tick)
end)

test("groups have volumes of their own", function()
  expect(sound.groups.music):equals(1)
  sound.groups.voices = 0.5
  expect(sound.groups.voices):equals(0.5)
  expect(sound.groups.effects):equals(1)
  sound.volume = 0.25
  expect(sound.volume):equals(0.25)
end)

test("music goes on through the same call", function()
  sound.music(tone, { volume = 0.5 })
  sound.music(tone)
  sound.music(nil, { fade = 0 })
  sound.music()
end)

test("mistakes have sentences", function()
  expect(function() sound.play(tone, { volume = 9 }) end):raises("sound.play: volume must be from 0 to 4 (got 9)")
  expect(function() sound.play(tone, { at = 3 }) end):raises("sound.play: at: vec3 or node expected, got a number")
  expect(function() sound.play(tone, { group = "efects" }) end):raises("sound.play: no group 'efects'; did you mean 'effects'?")
  expect(function() sound.groups.musik = 1 end):raises("sound.groups: no group 'musik'; did you mean 'music'?")
  expect(function() sound.groups.music = -1 end):raises("sound.groups.music: 0 to 4 expected, got -1")
  expect(function() sound.volume = 5 end):raises("sound.volume: 0 to 4 expected, got 5")
  expect(function() scene.add { sound = { file = tone, group = "xyz" } } end)
    :raises("no group 'xyz'; name it in game.json: \"sound\": { \"groups\": [\"xyz\"] }")
end)

test("a thousand loops are refused", function()
  expect(function() for _ = 1, 1000 do sound.play(tone, { loop = true }) end end):raises("200 sounds with loop = true are playing")
end)
