-- The rules of a round: points, streak and clock, and from where to throw. It hears what ball, hoop and targets tell.
local settings = require "settings"

local Match = behaviour {
  round_seconds = 60,
  most_times = 3,                     -- a streak makes points count up to so many times
  buzzer_scale = 0.4,                 -- the time's scale, while the last ball is in the air
  news_seconds = 1.3,
}

function Match:start()
  self.mode = "off"                   -- "off", "timed", "free", "over"
  self.score, self.throws, self.baskets, self.streak, self.best_streak = 0, 0, 0, 0, 0
  self.seconds_left = self.round_seconds
  self.news, self.news_at = "", -math.huge
  self.great = false                  -- is this throw worth a second look?
  self.spots, self.at_spot = scene.tagged("spot"), 1
  self.ball = scene.get("ball").behaviours.ball
  self.aim = scene.get("ball").behaviours.aim
  self.replay = scene.get("replay").behaviours.replay
  self:go_to_spot(1)
end

function Match:begin(mode)
  self.mode = mode
  if mode ~= "off" then sound.play("sounds/whistle.ogg") end
end
function Match:is_on() return self.mode == "timed" or self.mode == "free" end
function Match:times() return math.min(self.streak + 1, self.most_times) end
function Match:spot() return self.spots[self.at_spot].behaviours.spot end

function Match:go_to_spot(i)
  self:spot():light_up(false)
  self.at_spot = i
  self:spot():light_up(true)
  local hand = self:spot():hand_height()
  self.ball:wait_at(hand)
  self.aim.facing = (scene.get("hoop").world_position - hand):with_y(0):normalized()
end

function Match:update(dt)
  self.aim.is_allowed = self:is_on() and self.seconds_left > 0 and not self.replay.is_playing
  if self.mode ~= "timed" or self.replay.is_playing then return end
  self:count_down(dt)
  if self.seconds_left > 0 then return end
  if self.ball.state == "flying" then -- it still counts, and everybody holds their breath
    time.scale = self.buzzer_scale
    return
  end
  self.mode = "over"
  self.news, self.news_at = "Time!", time.now
  scene.send("time_up")
end

function Match:count_down(dt)
  local before = math.ceil(self.seconds_left)
  self.seconds_left = math.max(self.seconds_left - dt, 0)
  local now = math.ceil(self.seconds_left)
  if now < before and now == 0 then
    sound.play("sounds/buzzer.ogg", { at = scene.get("scoreboard") })
    scene.send("shake", 0.4)
  elseif now < before and now <= 5 then
    sound.play("sounds/tick.ogg")
  end
end

function Match:on_points(points, words)
  if not self:is_on() then return end
  local gained = points * self:times()
  self.score = self.score + gained
  self.news, self.news_at = ("%s +%d"):format(words, gained), time.now
  input.rumble(0.4, 0.2)
  sound.play("sounds/points.ogg", { pitch = 1 + 0.12 * math.min(self.streak, 8) })
  -- The first one that counts most often, and whatever falls after the buzzer.
  self.great = self.great or self.streak + 1 == self.most_times or self.seconds_left == 0
end

function Match:on_throw()
  self.great = false
  scene.get("fire").particles.playing = self:times() == self.most_times
end

function Match:on_throw_over(scored)
  time.scale = 1
  scene.get("fire").particles.playing = false
  if not self:is_on() then return end
  self.throws = self.throws + 1
  self.baskets = self.baskets + (scored and 1 or 0)
  self.streak = scored and self.streak + 1 or 0
  self.best_streak = math.max(self.best_streak, self.streak)
  if self.great and settings.replays then self.replay:play() end
  if scored then self:go_to_spot(self.at_spot % #self.spots + 1) end
end

return Match
