-- A plate on a hinge. A hit gives points; tearing it off gives more, whatever the throw gave already.
local Target = behaviour { points = 1, break_points = 5 }

function Target:on_collision_enter(hit)
  local ball = hit.node.behaviours.ball
  if not ball then return end
  ball:score(self.points, "Hit!")
  sound.hit("sounds/plate.ogg", hit, ball.loudest)
  tween(self.node:get("picture"), 0.15, { color = "white" }, { back = true })
end

function Target:on_joint_break()      -- once: a broken joint stays broken until the next round
  sound.play("sounds/snap.ogg", { at = self.node })
  self.node:get("sparks").particles:burst(60)
  scene.send("shake", 0.8)
  scene.send("points", self.break_points, "Snap!")
end

return Target
