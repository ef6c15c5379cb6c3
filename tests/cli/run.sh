#!/usr/bin/env bash
# What the program's verbs do, seen from outside: `tests/cli/run.sh build/release`. A line `ok` or `FAILED` for each claim.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/claims.sh"

program=$(readlink -f "${1:?usage: run.sh BUILD_FOLDER}")/tumble
planted=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/planted
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
unset DISPLAY WAYLAND_DISPLAY
export XDG_DATA_HOME=$work/data

has() { grep -qE -- "$2" "$1"; }
hash_of() { sed -n 's/.*"hash": "\([0-9a-f]\{16\}\)".*/\1/p' "$1"; }

game='Spiel mit ö'
made() { "$program" new "$game" && [[ -f $game/main.lua ]] && "$program" play "$game" --headless --ticks 60 --report a.json && has a.json '"ticks": 60, .*"script_errors": 0.*"dropped_seconds": 0\.0+,'; }
same_twice() {
  "$program" play "$game" --headless --bot --ticks 300 --save-replay input --report a.json &&
    "$program" play "$game" --headless --replay input --ticks 300 --report b.json && [[ $(hash_of a.json) && $(hash_of a.json) == "$(hash_of b.json)" ]]
}
own_tests() { "$program" test "$game" >tests && tail -n 1 tests | grep -qx '2 passed, 0 failed'; }
picture() { "$program" play "$game" --bot --ticks 30 --shot p.png --size 320x180 && has <(head -c 4 p.png) PNG; }
for_nobody() { "$program" play "$game" >sentence && has sentence "^No display here, so the game's bot played 20 s off screen; the picture is '$game.png'\.$" && [[ -s $game.png ]]; }
film() { "$program" play "$game" --bot --ticks 30 --record f.gif && has <(head -c 4 f.gif) GIF8; }
packed() {
  "$program" pack "$game" --output out && mkdir -p alone && mv "out/$game" alone && mv "$game" away &&
    (cd alone && "./$game" --headless --bot --ticks 60 --report r.json && has r.json '"ticks": 60') &&
    "$program" play "out/$game.tumble" --headless --ticks 60
  local status=$?
  mv away "$game"
  return $status
}
not_packed() {
  mkdir -p broken && echo 'error("broken")' >broken/main.lua
  refused 'did not run for 60 ticks' "$program" pack broken --output nothing && [[ -z $(ls -A nothing) ]]
}
never_over_a_source() {
  mkdir -p full && echo mine >"full/$game"
  refused 'is no package' "$program" pack "$game" --output full && [[ $(<"full/$game") == mine ]]
}
stored() {
  echo 'function start() storage.save("runs", storage.load("runs", 0) + 1) game.report.runs = storage.load("runs") end' >counter.lua
  echo 'return function() wait(1) end' >bot.lua
  for _ in 1 2; do "$program" play counter.lua --headless --ticks 2 --report r.json --save-replay second; done
  has r.json '"runs": 2' && [[ $(find data -type f) == data/tumble/counter-*/storage.json ]] &&
    "$program" play counter.lua --headless --bot --ticks 2 --report b.json && has b.json '"runs": 1' &&
    "$program" play counter.lua --headless --ticks 2 --report c.json && has c.json '"runs": 3' &&
    "$program" play counter.lua --headless --replay second --report d.json && has d.json '"runs": 2'
  local status=$?
  rm bot.lua
  return $status
}
script_error() {
  echo 'function update() error("late") end' >late.lua
  refused 'late.lua:1: late' "$program" play late.lua --headless --ticks 5
}

# Each mistake that expected.txt lists was planted; the game's other lines are right, so there is nothing else to tell.
planted_found() {
  local status=0 line
  "$program" check "$planted" >found && return 1
  while IFS= read -r line; do
    grep -qF -- "$line" found || { echo "not found: $line"; status=1; }
  done <"$planted/expected.txt"
  return $status
}
claim 'new: makes a game that runs' made
claim 'check: finds nothing wrong with a new game' "$program" check "$game"
claim 'check: finds every planted mistake' planted_found
claim 'new: refuses a folder that is there' refused 'exists already' "$program" new "$game"
claim 'new: refuses a name that is none' refused "cannot be a game's name" "$program" new .hidden
claim 'test: runs the tests of a game and counts them' own_tests
claim 'play: a replay gives the same hash' same_twice
claim 'play: --shot writes a picture of a run off screen' picture
claim 'play: without a display the bot plays, and a sentence says where the picture is' for_nobody
claim 'play: --record writes a film' film
claim 'play: --headless without an end is refused' refused 'add --ticks N' "$program" play "$game" --headless
claim 'play: a missing game is told in a sentence' refused "game 'nothing'" "$program" play nothing
claim 'play: what a game stores is there the next time, and bots and replays leave it alone' stored
claim 'play: an error in a script gives status 1' script_error
claim 'pack: what it writes runs alone, and its package plays' packed
claim 'pack: a game that fails is not packed' not_packed
claim 'pack: no other file is overwritten' never_over_a_source
claim 'an unknown verb is told with the known ones' refused "no verb 'plya'; the verbs are play" "$program" plya
exit $failures
