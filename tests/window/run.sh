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

# open GAME: plays it until it quits, once its window is there and in front. A small window, so that pictures come quickly.
open() {
  rm -f report.json
  "$program" play "$1" --no-watch --size 320x240 --report report.json --save-replay input.json >said 2>&1 &
  game=$!
  for _ in $(seq 200); do
    window=$(xdotool search --onlyvisible --pid $game 2>/dev/null | head -n 1) && [[ $window ]] && break
    sleep 0.1
  done
  xdotool windowfocus "$window" mousemove --window "$window" 160 120
  sync
}
# What follows waits for the game, which says each key that it hears, however slow the machine is just now.
heard() { grep -c '^heard' said; }
key() {
  local before
  before=$(heard)
  xdotool key "$1"
  for _ in $(seq 100); do (($(heard) > before)) && return; sleep 0.05; done
}
sync() { key n; key n; }  # the second is heard in a frame that began after all that came before the first
closed() {
  xdotool key F1
  for _ in $(seq 100); do kill -0 $game 2>/dev/null || break; sleep 0.1; done
  kill $game 2>/dev/null
  wait $game
}

setxkbmap de  # with keys for umlauts
cat >text.lua <<'LUA'
local text, keys = "", ""
function on_text(typed) text = text .. typed end
function on_press(name)
  print("heard " .. name)
  if name == "f1" then game.quit() end
  if #name == 1 then keys = keys .. name end
  game.report.text, game.report.keys = text, keys
end
function frame() if time.tick == 0 then print("drawn before its first tick") end end
LUA
# xdotool lends letters that no key bears a key for a moment, and the X server now and then takes the loan back too early:
# what arrives then is not what was typed, so it is typed again.
umlauts() {
  local _
  for _ in 1 2 3 4 5 6; do umlauts_once && return 0; done
  return 1
}
umlauts_once() {
  open text.lua
  xdotool type --delay 60 'Grüße, öl'
  sync
  closed && has '"text": "n*Grüße, öln*"' && has '"keys": "n*greln*"'
}
begun() { ! grep -q 'before its first tick' said; }
replayed() {
  local first
  first=$(sed -n 's/.*"hash": "\([0-9a-f]*\)".*/\1/p' report.json)
  "$program" play text.lua --headless --replay input.json --report report.json >said 2>&1 && has "\"hash\": \"$first\"" && has '"text": "n*Grüße, öln*"'
}

cat >look.lua <<'LUA'
local dx = 0
function on_press(name)
  print("heard " .. name)
  if name == "c" then input.pointer.captured = true end
  if name == "p" then time.paused = not time.paused end
  if name == "f1" then game.quit() end
  if name ~= "m" then return end
  table.insert(game.report.moves, math.floor(dx + 0.5))
  table.insert(game.report.places, math.floor(input.pointer.x + 0.5))
  dx = 0
end
function on_pointer_move(x) dx = dx + x end
function start() game.report.places, game.report.moves = {}, {} end
LUA
sweep() {  # four times 100 pixels to the right: more than from the middle to the window's edge
  for _ in 1 2 3 4; do xdotool mousemove_relative -- 100 0; sync; done
  key m
}
captured() {
  open look.lua
  key m                        # what led to the middle
  key c && sync && sweep       # captured: far beyond the window's edge, the place stands
  key Escape && sync && sweep  # free: it ends at the edge, or outside
  xdotool mousemove --window "$window" 50 120 && sync && key m
  xdotool click 1 && sync && sweep  # captured again by the click
  key p && sync && sweep       # paused: free
  key p
  closed
  # 240 pixels are 720 ui units, so 400 are 1200; the middle is at 480, and 50 pixels at 150.
  has '"moves": \[-?[0-9]+, 1200, [0-9]+, -?[0-9]+, 1200, [0-9]+\]' && has '"places": \[480, 480, [0-9]+, 150, 150, [0-9]+\]' &&
    ! has '"moves": \[-?[0-9]+, 1200, 1200,' && ! has '"moves": .* 1200\]'
}

cat >stopped.lua <<'LUA'
function on_press(name)
  print("heard " .. name)
  if name == "f1" then game.quit() end
end
LUA
stopped() {  # for a second: six ticks of it are caught up with, the rest is dropped and told
  open stopped.lua
  kill -STOP $game
  sleep 1
  kill -CONT $game
  sync
  closed && has '"dropped_seconds": (0\.[89]|[1-9])'
}

claim 'text: letters that no key bears come as they were typed, beside the keys' umlauts
claim 'start: the first picture is of a game that has begun' begun
claim 'text: a replay of what was typed gives the same hash' replayed
claim 'pointer: captured it goes on for ever; escape, a click and pause change hands' captured
claim 'time: what a game that stood still left out is told' stopped
exit $failures
