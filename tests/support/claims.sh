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
# ends_with STATUS TEXT COMMAND...: the command ends with that status and says so.
ends_with() {
  local expected=$1 text=$2 status=0
  shift 2
  "$@" >refusal 2>&1 || status=$?
  cat refusal
  [[ $status == "$expected" ]] && grep -qF -- "$text" refusal
}
refused() { ends_with 1 "$@"; }
