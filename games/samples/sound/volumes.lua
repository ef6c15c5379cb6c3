-- Listen: tab changes the tune, one fading into the other; up and down set how loud music is, left and right the effects; space
-- rings, p pauses: the bell and the music stop and go on, but what begins in a pause is heard.
local tunes = { "calm.ogg", "lively.ogg" }
local tune = 1

scene.add { name = "camera", position = vec3(0, 0, 6), camera = {} }

function start() sound.music(tunes[tune]) end

local function change(group, by)
  sound.groups[group] = math.clamp(sound.groups[group] + by, 0, 1)
  sound.play("bell.wav", { group = group })                    -- so that one hears how loud it is now
end

function on_press(name)
  if name == "tab" then
    tune = tune % #tunes + 1
    sound.music(tunes[tune], { fade = 2 })
  end
  if name == "up" then change("music", 0.1) elseif name == "down" then change("music", -0.1) end
  if name == "right" then change("effects", 0.1) elseif name == "left" then change("effects", -0.1) end
  if name == "space" then sound.play("bell.wav", { pitch = random.between(0.8, 1.2) }) end
  if name == "p" then time.paused = not time.paused end
end

function draw_ui()
  ui.text(("%s   music %.1f   effects %.1f%s"):format(tunes[tune], sound.groups.music, sound.groups.effects, time.paused and "   paused" or ""),
    { at = "center" })
end
