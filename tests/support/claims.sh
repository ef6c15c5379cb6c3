# For shell tests: a line `ok` or `FAILED` for each claim. The test ends with `exit $failures`.

failures=0
# claim NAME COMMAND...: the command is true. What it says is shown only where it is not.
claim() {
  local name=$1
  shift
  if "$@" >said 2>&1; then
    printf 'ok %s\n' "$name"
  else
    printf 'FAILED %s\n' "$name"
    tail -n 40 said | sed 's/^/  /'
    failures=1
  fi
}
# refused TEXT COMMAND...: the command fails with status 1 and says so.
refused() {
  local text=$1 status=0
  shift
  "$@" >refusal 2>&1 || status=$?
  cat refusal
  [[ $status == 1 ]] && grep -qF -- "$text" refusal
}
