#!/usr/bin/env bash
# What `tumble measure` promises, seen from outside: `tests/accuracy/run.sh build/release`. A line `ok` or `FAILED` for each
# claim. The spoiled runs show that the suite can fail.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/claims.sh"

program=$(readlink -f "${1:?usage: run.sh BUILD_FOLDER}")/tumble
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Column NAME of the rows of our engine in a CSV, whose quoted fields may hold commas.
column() {
  sed -E ':again; s/("[^",]*),([^"]*")/\1;\2/; t again' "$1" |
    awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i == name) c = i; if ($i == "engine") e = i }; next } $e == "tumble" { print $c }'
}

# Each case of the suite is there: 32 of accuracy, 35 of stability, and the scenes that separate engines.
complete() {
  "$program" measure --list >list || return 1
  local id
  for id in $(printf 'A%02d ' {1..32}) $(printf 'B%02d ' {1..35}) $(printf 'S%02d ' {1..9}); do
    grep -q "^$id " list || { echo "no case $id"; return 1; }
  done
}
both_engines() {
  "$program" measure --case A01 --csv rows.csv && cut -d, -f2 rows.csv | sort -u | tr '\n' ' ' | grep -qx 'engine stock tumble ' &&
    [[ $(column rows.csv passed | sort -u) == 1 ]]
}
# A reference that is wrong by one per cent: nothing that is measured against it passes any more.
perturbed() {
  "$program" measure --case "$1" --engine tumble --default-only --csv right.csv &&
    "$program" measure --case "$1" --engine tumble --default-only --perturb 0.01 --csv wrong.csv || return 1
  paste -d' ' <(column right.csv passed) <(column wrong.csv passed) >pairs
  cat pairs
  grep -q '^1 ' pairs && ! grep -q '^1 1$' pairs
}
# The rows of standard input without their times, which differ from run to run; of cases whose parts have no commas.
without_times() {
  awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i == "cost_low") low = i; if ($i == "cost_high") high = i } }
                    NR > 1 { $low = ""; $high = "" } { print }'
}
# One iteration in place of ten: the comparison must see it, and must see nothing where nothing was spoiled.
spoiled() {
  mkdir -p base
  "$program" measure --case "$1" --engine tumble --default-only --csv timed.csv && without_times <timed.csv >base/rows.csv || return 1
  "$program" measure --case "$1" --engine tumble --default-only --baseline base --compare || { echo 'the same run differs from itself'; return 1; }
  local status=0
  "$program" measure --case "$1" --engine tumble --knobs 1x1 --baseline base --compare >compared || status=$?
  cat compared
  [[ $status == 1 ]] && grep -q '^WORSE' compared
}
report() {
  "$program" measure --case A01 --csv rows.csv --report out && [[ -s out/a01-cost.svg && -s out/a01-order.svg ]] &&
    grep -q 'id=A01' out/index.html && "$program" measure --rows rows.csv --report again && cmp out/index.html again/index.html
}
claim 'measure: every case of the suite is listed' complete
claim 'measure: one case runs on both engines' both_engines
for id in A01 A02 A28; do claim "measure: $id fails where its reference is wrong by 1 %" perturbed $id; done
claim 'measure: --compare notices a spoiled setting' spoiled B01
claim 'measure: the report has its plots, and comes the same from the rows' report
# Status 2 is not the 1 of "something got worse".
claim 'measure: an unknown case is refused' ends_with 2 "no case 'A99'" "$program" measure --case A99
claim 'measure: --compare without a baseline is no verdict' ends_with 2 'no baseline in' "$program" measure --case A01 --compare --baseline nowhere
claim 'measure: options of the suite are refused with a game' refused 'belongs to the suite' "$program" measure nothing --quick
exit $failures
