#!/usr/bin/env bash
# A person at a real window, on a screen that nobody sees: `tests/window/run.sh build/release`. A line `ok` or `FAILED` for
# each claim.
set -uo pipefail

program=$(readlink -f "${1:?usage: run.sh BUILD_FOLDER}")/tumble
work=$(mktemp -d)
cd "$work"
export XDG_DATA_HOME=$work/data
unset WAYLAND_DISPLAY SDL_VIDEODRIVER

# The server says which number was free.
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp 3>number 2>/dev/null &
server=$!
trap 'kill $server 2>/dev/null; rm -rf "$work"' EXIT
for _ in $(seq 50); do [[ -s number ]] && break; sleep 0.1; done
export DISPLAY=:$(<number)
for _ in $(seq 50); do xdotool getmouselocation >/dev/null 2>&1 && break; sleep 0.1; done

failures=0
# claim NAME COMMAND...: the command is true. What the game said is shown only where it is not.
claim() {
  local name=$1
  shift
  if "$@"; then
    printf 'ok %s\n' "$name"
  else
    printf 'FAILED %s\n' "$name"
    cat said report.json 2>/dev/null | sed 's/^/  /'
    failures=1
  fi
}
has() { grep -qE -- "$1" report.json; }

# open GAME: plays it until it quits, once its window is there and in front.
open() {
  rm -f report.json
  "$program" play "$1" --no-watch --size 640x480 --report report.json --save-replay input.json >said 2>&1 &
  game=$!
  for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --pid $game 2>/dev/null | head -n 1) && [[ $window ]] && break
    sleep 0.1
  done
  xdotool windowfocus "$window" mousemove --window "$window" 320 240 sleep 0.3
}
# Lets it end by itself, or ends it.
closed() {
  for _ in $(seq 100); do kill -0 $game 2>/dev/null || break; sleep 0.1; done
  kill $game 2>/dev/null
  wait $game
}

cat >text.lua <<'LUA'
local text, keys = "", ""
function on_text(typed) text = text .. typed end
function on_press(name)
  if name == "f1" then game.quit() end
  if #name == 1 then keys = keys .. name end
  game.report.text, game.report.keys = text, keys
end
LUA
umlauts() {
  open text.lua
  xdotool type --delay 200 'Grüße, Zoë'
  xdotool sleep 0.3 key F1
  closed && has '"text": "Grüße, Zoë"' && has '"keys": "[a-z]*gr[a-z]*"'
}
replayed() {
  local first
  first=$(sed -n 's/.*"hash": "\([0-9a-f]*\)".*/\1/p' report.json)
  "$program" play text.lua --headless --replay input.json --report report.json >said 2>&1 && has "\"hash\": \"$first\"" && has '"text": "Grüße, Zoë"'
}

cat >look.lua <<'LUA'
local dx, last = 0, 0
function on_press(name)
  if name == "c" then input.pointer.captured = true end
  if name == "p" then time.paused = not time.paused end
  if name == "m" then game.report["moved_" .. #game.report.places] = math.floor(dx + 0.5) end
  if name == "f1" then game.quit() end
  if name == "m" then table.insert(game.report.places, math.floor(input.pointer.x + 0.5)) dx = 0 end
end
function on_pointer_move(x) dx = dx + x end
function start() game.report.places = {} end
LUA
sweep() {  # four times 150 pixels to the right: more than from the middle to the window's edge
  for _ in 1 2 3 4; do xdotool mousemove_relative -- 150 0 sleep 0.05; done
  xdotool sleep 0.2 key m sleep 0.2
}
captured() {
  open look.lua
  xdotool key c sleep 0.2
  sweep                        # captured: far beyond the window's edge, the place stands
  xdotool key Escape sleep 0.2
  sweep                        # free: it ends at the edge, or outside
  xdotool mousemove --window "$window" 100 240 sleep 0.1 click 1 sleep 0.2
  sweep                        # captured again by the click
  xdotool key p sleep 0.2
  sweep                        # paused: free
  xdotool key p sleep 0.2 key F1
  closed
  # 600 pixels of a window 480 high are 900 ui units; a place is counted from the left.
  has '"moved_0": 900' && has '"moved_2": 900' && has '"places": \[480, [0-9]+, 150, [0-9]+\]' &&
    ! has '"moved_1": 900' && ! has '"moved_3": 900'
}

claim 'text: letters that no key bears come as they were typed, beside the keys' umlauts
claim 'text: a replay of what was typed gives the same hash' replayed
claim 'pointer: captured it goes on for ever; escape, a click and pause change hands' captured
exit $failures
