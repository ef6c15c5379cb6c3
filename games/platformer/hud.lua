-- What is on the screen while one plays.
local hud = {}

local paper, gold, amber = color "#22304acc", "#ffd24a", "#f2a01b"
local news, news_until = "", 0          -- a line that is shown for a while

function hud.clock(seconds) return ("%d:%04.1f"):format(seconds // 60, seconds % 60) end

function hud.tell(text) news, news_until = text, time.now + 2 end

-- For one tick, at the lower edge.
function hud.hint(text)
  ui.panel({ at = "bottom", y = -28, color = paper, padding = 14 }, function() ui.text(text, { size = 26 }) end)
end

function hud.draw(run)
  ui.box { x = 20, y = 20, width = 150, height = 52, radius = 26, color = paper }
  ui.box { x = 28, y = 28, width = 36, height = 36, radius = 18, color = amber }
  ui.box { x = 34, y = 34, width = 24, height = 24, radius = 12, color = gold }
  ui.text(("%d / %d"):format(run.coins, run.all_coins), { x = 76, y = 30, size = 28 })
  ui.box { x = ui.width - 150, y = 20, width = 130, height = 52, radius = 26, color = paper }
  ui.text(hud.clock(run.seconds), { x = ui.width - 128, y = 30, size = 28 })
  if time.now < news_until then
    ui.panel({ at = "top", y = 20, color = paper, padding = 12, radius = 26 }, function() ui.text(news, { size = 28, color = gold }) end)
  end
end

return hud
