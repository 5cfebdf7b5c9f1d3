# contensou sweep: killed at any moment, the same command goes on, redoes nothing and loses nothing; another one is refused.
. "$(dirname "$0")/check.sh"
. "$(dirname "$0")/sweep_common.sh"

# 40 runs of some 10 ms.
grid() { sweep --set scene.duration=2 --vary initial.psi_dot=150:240:40 --jobs 2 "$@"; }
grid --quiet --out whole.tsv
succeeds

# Killed again and again (SIGKILL), a third of a second later each time: rows only grow, none is computed twice. A row that was
# written stays as it is, wall_seconds included; so that a run done again would be seen.
tries=0
: >kept
status=137
while [ "$status" -eq 137 ] && [ $tries -lt 60 ]; do
  tries=$((tries + 1))
  command="contensou sweep, killed, try $tries"
  status=0
  timeout -s KILL 0.1 "$program" sweep top.toml --set scene.duration=2 --vary initial.psi_dot=150:240:40 --jobs 2 --quiet \
    --out killed.tsv >out 2>err || status=$?
  check "status $status: $(cat err)" [ "$status" -eq 137 -o "$status" -eq 0 ]
  [ -e killed.tsv ] || continue
  grep '^[0-9].*[0-9]$' killed.tsv | sort >now
  # All that was there is there still, but for a last line that was torn (none is, where the system writes a line at once).
  check "rows lost or done again" [ -z "$(comm -23 kept now)" ]
  cp now kept
done
grid --quiet --out killed.tsv
succeeds
check "killed $tries times, 40 rows expected: $(rows killed.tsv)" [ "$(rows killed.tsv)" -eq 40 ]
grep '^[0-9]' killed.tsv | sort >now
check "rows lost or done again at the end" [ -z "$(comm -23 kept now)" ]
check "another result" same whole.tsv killed.tsv

# A torn last line, of every kind: dropped, its run and the missing ones done, no other.
head -n 24 whole.tsv >good.tsv # 4 lines of header, runs 0 to 19
sed -n 25p whole.tsv >line     # run 20
length=$(wc -c <line)
for keep in 1 2 3 10 $((length / 2)) $((length - 2)) $((length - 1)); do
  { cat good.tsv; head -c $keep line; } >torn.tsv
  grid --out torn.tsv
  succeeds
  check "$keep bytes: $(cat out)" grep -q '^40 of 40 runs, 20 of them now' out
  check "$keep bytes: another result" same whole.tsv torn.tsv
  check "$keep bytes: rows were touched" [ -z "$(grep '^[0-9]' good.tsv | sort >a; grep '^[0-9]' torn.tsv | sort >b; comm -23 a b)" ]
done
# A whole last line that is none, as a power failure may leave it.
{ cat good.tsv; printf '20\t150\0\0\0\0\n'; } >torn.tsv
grid --quiet --out torn.tsv
succeeds
check "another result" same whole.tsv torn.tsv

# Rows in another order, a table that is complete: nothing is computed, the order is made.
{ head -n 4 whole.tsv; tail -n +5 whole.tsv | sort -r; } >order.tsv
grid --out order.tsv
succeeds
check "computed: $(cat out)" grep -q '^40 of 40 runs, 0 of them now' out
check "the same to the byte" cmp -s whole.tsv order.tsv

# Tables of something else are refused, in one line, and left as they are; --restart overwrites.
refuses_table() { # WORD ARGUMENT...: good.tsv is not of this sweep
  words=$1
  shift
  cp good.tsv other.tsv
  run sweep "$@" --out other.tsv
  refused other.tsv "$words" 'expected'
  check "touched" cmp -s good.tsv other.tsv
}
of_another='not of this sweep'
same_grid='--vary initial.psi_dot=150:240:40'
refuses_table "$of_another" top.toml --set scene.duration=2.5 $same_grid
refuses_table --restart     top.toml $same_grid
refuses_table "$of_another" top.toml --set scene.duration=2 --vary initial.psi_dot=150:240:41
refuses_table "$of_another" top.toml --set scene.duration=2 --vary initial.psi_dot=150:241:40
refuses_table "$of_another" top.toml --set scene.duration=2 $same_grid --vary contact.body.mu=0.3
sed 's/^mu *= 0.3/mu = 0.31/' top.toml >changed.toml
refuses_table "$of_another" changed.toml --set scene.duration=2 $same_grid
echo 'my notes' >notes
run sweep top.toml --set scene.duration=0.01 --vary contact.body.mu=0.1,0.3 --out notes
refused notes "$of_another"
check "notes" [ "$(cat notes)" = 'my notes' ]
sed '10s/.*/something else/' good.tsv >broken.tsv
grid --out broken.tsv
refused broken.tsv:10 'no row' expected
run sweep top.toml --set scene.duration=0.01 --vary contact.body.mu=0.1,0.3 --out notes --restart --quiet
succeeds
check "restarted" [ "$(rows notes)" -eq 2 ]
# The same scene by another name or from another folder is the same.
mkdir elsewhere && cp top.toml elsewhere/named.toml
cp whole.tsv moved.tsv
run sweep elsewhere/named.toml --set scene.duration=2 $same_grid --out moved.tsv
succeeds
check "computed: $(cat out)" grep -q ' 0 of them now' out

# Runs of half a second and more on any machine, so that a sweep of them is still at it when something happens to it.
slow="$same_grid --set scene.duration=0.5 --set integrator.method=moreau --set integrator.step=1e-5"
wait_until() { # COMMAND...: some 30 s at most
  tries=0
  until "$@" || [ $tries -ge 300 ]; do
    tries=$((tries + 1))
    sleep 0.1
  done
}
has_rows() { [ -e "$1" ] && [ "$(rows "$1")" -ge 1 ]; }

# Ctrl-C: what was begun is finished and written, and one line says how to go on; the same for SIGTERM.
for signal in INT:130 TERM:143; do
  command="contensou sweep, SIG${signal%:*}"
  rm -f stopped.tsv
  "$program" sweep top.toml $slow --jobs 2 --out stopped.tsv >out 2>err &
  pid=$!
  wait_until has_rows stopped.tsv
  kill -${signal%:*} $pid
  status=0
  wait $pid || status=$?
  check "exit status $status" [ "$status" -eq ${signal#*:} ]
  check "one line: $(cat err)" [ "$(wc -l <err)" -eq 1 ]
  check "how to go on: $(cat err)" grep -q 'of 40 runs are in stopped.tsv; the same command goes on' err
  check "whole rows" [ "$(sed -n 's/.*stopped: \([0-9]*\) of.*/\1/p' err)" = "$(awk -F '\t' 'NF == 8 && $1 ~ /^[0-9]+$/' stopped.tsv | wc -l)" ]
done

# Two at once on one table: the second is refused.
command='contensou sweep, two at once'
rm -f both.tsv
"$program" sweep top.toml $slow --jobs 1 --quiet --out both.tsv 2>stopped_err &
pid=$!
wait_until has_rows both.tsv
run sweep top.toml $slow --jobs 1 --quiet --out both.tsv
refused both.tsv 'another sweep'
kill $pid
wait $pid

# A disk that fills up: status 1, one line; what is there can be gone on with.
command='contensou sweep, files of at most 2 KiB'
status=0
(trap '' XFSZ; ulimit -f 4; exec "$program" sweep top.toml --set scene.duration=2 $same_grid --quiet --out full.tsv >out 2>err) || status=$?
check "exit status $status, expected 1" [ "$status" -eq 1 ]
check "one line: $(cat err)" [ "$(wc -l <err)" -eq 1 ]
check "which: $(cat err)" grep -q 'full.tsv: cannot be written' err
grid --quiet --out full.tsv
succeeds
check "another result after a full disk" same whole.tsv full.tsv

finish
