-- Plays a round with the pointer, as a person would: it may look at everything and move nothing but the controls.

-- How far to pull, to the right and back, so that the ball comes down at a place.
local function pull_to(place, aim)
  local way = place - aim.ball.home
  local flat, lift = way:with_y(0), math.rad(aim.lift_degrees)
  local distance = flat:length()
  -- The parabola's height there is d tan(lift) - g d^2 / (2 v^2 cos^2(lift)): solved for v.
  local speed = distance / math.cos(lift) * math.sqrt(-physics.gravity.y / 2 / (distance * math.tan(lift) - way.y))
  local turn = flat:angle(aim.facing) * math.sign(aim.facing:cross(flat).y)
  return turn / math.rad(aim.widest_degrees) * aim.full_pull,
    (speed - aim.slowest) / (aim.fastest - aim.slowest) * aim.full_pull
end

local function throw_at(place, aim)
  local right, back = pull_to(place, aim)
  point_at(640, 380)
  press("pointer")
  point_at(640 + right, 380 + back, 0.5)   -- goes there in half a second
  release("pointer")
  wait(0.1)
end

return function()
  wait(1)
  click("Play")
  wait(0.1)
  local targets = { "hoop", "hoop", "hoop", "hoop", "plate 1", "hoop", "hoop", "plate 2" }
  local next_target, n = "plate 3", 0      -- the golden one once, while it hangs
  while not game.is_finished do
    local aim = scene.get("ball").behaviours.aim
    if aim.is_allowed and aim.ball.state == "held" then
      throw_at(scene.get(next_target).world_position, aim)
      n = n % #targets + 1
      next_target = targets[n]
    end
    wait(0.1)
  end
end
