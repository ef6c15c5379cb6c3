-- Listen: crates fall, and each knock is as loud as the hit was hard; space drops another one.
local dropped = 0

scene.add { name = "camera", position = vec3(0, 3, 9), rotation_degrees = vec3(-12, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "gray",
  mesh = { shape = "box", size = vec3(14, 0.2, 10) }, body = "static" }

local function drop()
  dropped = dropped + 1
  local crate = scene.add { name = "crate " .. dropped, position = vec3(random.between(-2, 2), random.between(3, 6), random.between(-1, 1)),
    rotation_degrees = vec3(random.between(0, 90), random.between(0, 90), 0), color = "peru", mesh = "box", body = { mass = 4, restitution = 0.3 } }
  function crate.on_collision_enter(hit) sound.hit("knock.wav", hit, 25) end   -- 25 N s are heard in full
end

function start() task.spawn(function()
  for _ = 1, 6 do
    drop()
    wait(0.5)
  end
end) end

function on_press(name)
  if name == "space" then drop() end
end
