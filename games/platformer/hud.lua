-- What is on the screen while one plays.
local hud = {}

local ink, paper, gold = "#ffffff", color "#1d2b3acc", "#ffd24a"
local news, news_until = "", 0          -- a line that is shown for a while

local function clock(seconds) return ("%d:%04.1f"):format(seconds // 60, seconds % 60) end

function hud.tell(text) news, news_until = text, time.now + 2 end

-- For one tick, at the lower edge.
function hud.hint(text)
  local width = 60 + 13 * #text
  ui.box { x = (ui.width - width) / 2, y = 636, width = width, height = 54, color = paper }
  ui.text(text, { at = "bottom", y = -16, size = 26, color = ink })
end

function hud.draw(run)
  ui.box { x = 16, y = 16, width = 268, height = 76, color = paper }
  ui.text(("Coins %d / %d"):format(run.coins, run.all_coins), { x = 32, y = 24, size = 30, color = ink })
  ui.bar(run.coins / math.max(1, run.all_coins), { x = 32, y = 66, width = 236, height = 12, color = gold })
  ui.box { x = ui.width - 136, y = 16, width = 120, height = 46, color = paper }
  ui.text(clock(run.seconds), { at = "top_right", size = 30, color = ink })
  if time.now < news_until then
    ui.box { x = (ui.width - 440) / 2, y = 16, width = 440, height = 54, color = paper }
    ui.text(news, { at = "top", size = 34, color = gold })
  end
end

return hud
