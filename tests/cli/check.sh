# What the tests of the program share. Each is a shell script, called as: sh TEST.sh PROGRAM; source this first.
#   run ARGUMENT...       runs the program, standard input as it is; then $status, $folder/out, $folder/err
#   fail MESSAGE          notes a failure and goes on; the script ends with: finish

program=$1
[ -x "$program" ] || { echo "FAILED: no program at '$program'"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
checks=0
command=

run() {
  command="contensou $*"
  status=0
  "$program" "$@" >"$folder/out" 2>"$folder/err" || status=$?
}

fail() {
  failures=$((failures + 1))
  echo "FAILED: $command: $1"
}

check() { # check MESSAGE CONDITION...: the condition is a command
  checks=$((checks + 1))
  message=$1
  shift
  "$@" || fail "$message"
}

succeeds() {
  check "exit status $status, expected 0" [ "$status" -eq 0 ]
  check "says on standard error: $(head -c 200 "$folder/err")" [ ! -s "$folder/err" ]
}

# refused SOURCE VALUE EXPECTED: status 2, one line on standard error that holds all three, nothing on standard output.
refused() {
  check "exit status $status, expected 2" [ "$status" -eq 2 ]
  check "wrote to standard output" [ ! -s "$folder/out" ]
  check "$(wc -l <"$folder/err") lines on standard error, expected 1" [ "$(wc -l <"$folder/err")" -eq 1 ]
  for word in "contensou" "$@"; do
    check "'$word' is missing in the message: $(cat "$folder/err")" grep -qF -e "$word" "$folder/err"
  done
}

# row U PHI XI ETA BOUND: the table just printed has this row, each value within BOUND, relative (so a 0 is exactly 0).
row() {
  checks=$((checks + 1))
  awk -F '\t' -v u="$1" -v phi="$2" -v xi="$3" -v eta="$4" -v bound="$5" '
    function off(got, want) {
      if (got !~ /^[0-9][0-9.e+-]*$/) return 1
      d = got - want
      return !((d < 0 ? -d : d) <= bound * want)
    }
    $1 == u && /^[^#u]/ { found = 1; if (off($2, phi) || off($3, xi) || off($4, eta)) { print "got: " $0; exit 1 } }
    END { if (!found) { print "no row u = " u; exit 1 } }' "$folder/out" || fail "u = $1: expected $2 $3 $4"
}

finish() {
  echo "$checks checks, $failures failed"
  [ "$failures" -eq 0 ] && [ "$checks" -gt 0 ]
}
