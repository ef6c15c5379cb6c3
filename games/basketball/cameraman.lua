-- Where the picture is taken from: round the yard on the title, behind the ball in a round, beside the hoop in a replay.
local Cameraman = behaviour {
  behind = 3.8, above = 1.1,          -- m, from the ball that waits
  smoothing = 0.35,                   -- s in which it closes two thirds of a gap
  round_seconds = 60,                 -- once round the title's view
}

function Cameraman:start()
  self.replay = scene.get("replay").behaviours.replay
  self.match = scene.get("match").behaviours.match
  self.hoop = scene.get("hoop").world_position
  self.was = ""                       -- the view of the last tick
  self.looks_at = self.hoop
end

function Cameraman:title_view()
  local turn = 0.6 * math.sin(time.now * 2 * math.pi / self.round_seconds) - 0.5
  return vec3(8 * math.sin(turn), 2.4, -2 + 8 * math.cos(turn)), vec3(0, 2.5, -4)
end

function Cameraman:play_view()
  local ball, ahead = self.match.ball, self.match.aim.facing
  local goal = self.hoop - vec3.up * 0.45
  if ball.state == "flying" then goal = goal:lerp(ball.node.position, 0.12) end   -- a glance after it
  return ball.home - ahead * self.behind + vec3.up * self.above, goal
end

function Cameraman:replay_view()
  local ball = scene.get("ball/picture").world_position
  local side = self.match.ball.home.x > 0 and -1 or 1
  return self.hoop + vec3(2.1 * side, -0.5, 2.2), self.hoop:lerp(ball, 0.18)
end

function Cameraman:late_update(dt)
  local view = self.replay.is_playing and "replay" or self.match.mode == "off" and "title" or "play"
  local place, goal = self[view .. "_view"](self)
  if view ~= self.was and (view == "replay" or self.was == "replay" or self.was == "") then
    self.node:teleport(place)         -- a cut
    self.looks_at = goal
  else
    local part = 1 - math.exp(-dt / self.smoothing)
    self.node.position = self.node.position:lerp(place, part)
    self.looks_at = self.looks_at:lerp(goal, part)
  end
  self.was = view
  self.node:look_at(self.looks_at)
end

return Cameraman
