-- Watch: one weight after the other is laid into the pan, until the rope has to hold more than `break_force`. A joint
-- that broke is gone for good; its bodies are told by on_joint_break.
local break_force = 480                                                  -- N; each weight of 10 kg pulls with 98

scene.add { name = "camera", position = vec3(0, 2, 8), camera = {} }
local hook = scene.add { name = "hook", position = vec3(0, 4, 0), color = "dimgray", mesh = { shape = "sphere", radius = 0.12 },
  body = "static" }
local pan = scene.add { name = "pan", position = vec3(0, 1.5, 0), color = "peru", mesh = { shape = "box", size = vec3(1.6, 0.1, 1.6) },
  body = { mass = 4, angular_damping = 2 } }
local rope = joint.ball { name = "rope", a = pan, b = hook, anchor = vec3(0, 2.5, 0), break_force = break_force }

function pan.on_joint_break() print("it broke") end

local function load(count)
  if rope.is_broken then return end
  local around = quat.axis_angle(vec3.up, count * 2 * math.pi / 5) * vec3(0.5, 0, 0)
  scene.add { position = pan:to_world(around + vec3(0, 0.2, 0)), color = "slategray",
    mesh = { shape = "cylinder", radius = 0.2, height = 0.25 }, body = { mass = 10, friction = 0.8 } }
  task.after(1.5, load, count + 1)
end

function start() task.after(1, load, 1) end

function update(dt)
  if not rope.is_broken then draw.line(hook.position, pan.position, "burlywood") end
  log.watch("force, N", math.round(rope.force:length()))
end
