-- Watch: the basket is one body: its walls are solid, and one collider in it is a trigger, which lets everything through
-- and tells who came and went. It counts the balls, and they glow while they are inside. The arrow keys move it.
scene.add { name = "camera", position = vec3(0, 2.6, 7), rotation_degrees = vec3(-8, 0, 0), camera = {} }
scene.add { name = "floor", position = vec3(0, -0.1, 0), color = "#3b3a5a",
  mesh = { shape = "box", size = vec3(12, 0.2, 5) }, body = "static" }

local parts = {                                            -- middle and size
  { vec3(0, 0.05, 0), vec3(2, 0.1, 1.2) },
  { vec3(-0.95, 0.5, 0), vec3(0.1, 0.8, 1.2) }, { vec3(0.95, 0.5, 0), vec3(0.1, 0.8, 1.2) },
  { vec3(0, 0.5, -0.55), vec3(2, 0.8, 0.1) }, { vec3(0, 0.5, 0.55), vec3(2, 0.8, 0.1) },
}
local colliders, walls = {}, {}
for i, part in ipairs(parts) do
  colliders[i] = { shape = "box", offset = part[1], size = part[2] }
  walls[i] = { position = part[1], mesh = { shape = "box", size = part[2] },
    material = { color = "sandybrown", opacity = i == 5 and 0.3 or 1 } }
end
table.insert(colliders, { shape = "box", offset = vec3(0, 0.5, 0), size = vec3(1.8, 0.8, 1), trigger = true })
local basket = scene.add { name = "basket", position = vec3(0, 0.2, 0), children = walls,
  body = { type = "kinematic", friction = 0.8, colliders = colliders } }

local inside, aim = 0, 2.5
function basket.on_trigger_enter(hit)
  inside = inside + 1
  hit.node.material = { color = "gold", glow = 0.8 }
end
function basket.on_trigger_exit(hit)
  inside = inside - 1
  hit.node.material = { color = "slateblue" }
end

local function drop()
  local ball = scene.add { position = vec3(random.between(-3, 3), 5, 0), color = "slateblue",
    mesh = { shape = "sphere", radius = 0.16 }, body = { mass = 0.2, restitution = 0.4 } }
  task.after(7, ball.destroy, ball)
end

function start() task.every(0.25, drop) end
function update(dt)
  local x = basket.position.x
  if math.abs(x - aim) < 0.01 then aim = -aim end
  local goal = input.is_down("left") and -3 or input.is_down("right") and 3 or aim
  basket.position = vec3(math.approach(x, goal, 1.5 * dt), 0.2, 0)
  draw.text(basket.position + vec3(-0.6, 1.3, 0), inside .. " inside", "white", 28)
end
