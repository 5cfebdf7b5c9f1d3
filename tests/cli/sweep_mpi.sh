# contensou sweep under MPI: four processes on one machine give what one gives; errors are said once; killed, it goes on.
# Skipped where there is no MPI. Called as: sh sweep_mpi.sh PROGRAM MPIRUN
mpirun=$2
. "$(dirname "$0")/check.sh"
. "$(dirname "$0")/sweep_common.sh"
[ -x "$mpirun" ] || { echo "SKIPPED: the program was built without MPI, or there is no mpirun"; exit 77; }
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM

ranks() { # ranks N ARGUMENT...: $program sweep by N processes
  n=$1
  shift
  command="mpirun -n $n contensou sweep $*"
  status=0
  timeout 60 "$mpirun" --quiet --oversubscribe -n "$n" "$program" sweep "$@" >out 2>err || status=$?
  # What Open MPI says of a machine that shows it no topology (no /sys, as in some containers) is not ours.
  sed -i '/^\[hwloc\//d' err
}

grid='--set scene.duration=2 --vary contact.body.radius=1e-4,1e-3 --vary initial.psi_dot=150:240:10'
sweep $grid --quiet --out plain.tsv
succeeds
for n in 1 4; do
  ranks $n top.toml $grid --out ranks_$n.tsv
  succeeds
  check "the closing line, once: $(cat out)" [ "$(cat out | grep -c '^20 of 20 runs, 20 of them now')" -eq 1 ]
  check "$n processes: another result" same plain.tsv ranks_$n.tsv
done
# More processes than runs.
ranks 4 top.toml --set scene.duration=0.01 --vary contact.body.mu=0.1,0.3 --quiet --out few.tsv
succeeds
check "two rows" [ "$(rows few.tsv)" -eq 2 ]

# One goes on where the other stopped.
head -n 12 plain.tsv >half.tsv
ranks 3 top.toml $grid --out half.tsv
succeeds
check "done again: $(cat out)" grep -q '^20 of 20 runs, 12 of them now' out
check "another result" same plain.tsv half.tsv

# Bad input: one line of ours, from one process, status 2, and it ends.
said_once() {
  check "exit status $status, expected 2" [ "$status" -eq 2 ]
  check "said $(grep -c '^contensou' err) times: $(cat err)" [ "$(grep -c '^contensou sweep: ' err)" -eq 1 ]
  check "'$1' is missing: $(cat err)" grep -qF -e "$1" err
}
ranks 4 top.toml --vary contact.body.mu=0.1:-0.1:3 --out never.tsv;          said_once 'run 2 (contact.body.mu=-0.1)'
ranks 4 nosuch.toml --vary contact.body.mu=0.1,0.3 --out never.tsv;          said_once 'nosuch.toml: cannot be read'
ranks 4 top.toml --nosuch;                                                   said_once '"--nosuch"'
ranks 4 top.toml --vary contact.body.mu=0.1,0.3 --jobs 2 --out never.tsv;    said_once '--jobs'
ranks 4 top.toml --set scene.duration=1 --vary contact.body.mu=0.1,0.3 --out plain.tsv; said_once 'not of this sweep'
check "never.tsv was written" [ ! -e never.tsv ]

# A disk that fills up: status 1, said once, no hang. Files of at most 8 MiB, which MPI's own are not; the table, by a comment,
# nearly that at the start.
command='mpirun contensou sweep, a full disk'
{ head -n 3 plain.tsv; printf '# '; head -c 8387300 /dev/zero | tr '\0' '-'; echo; sed -n 4p plain.tsv; } >full.tsv
status=0
(trap '' XFSZ; ulimit -f 16384; exec timeout 60 "$mpirun" --quiet --oversubscribe -n 3 "$program" sweep top.toml $grid --quiet \
  --out full.tsv >out 2>err) || status=$?
check "exit status $status, expected 1" [ "$status" -eq 1 ]
check "said: $(head -c 1000 err)" [ "$(grep -c 'full.tsv: cannot be written' err)" -eq 1 ]
rm full.tsv

# Interrupted, or a process killed in the middle, one that computes or the one that has the file: the job ends, the table is whole,
# and the same command goes on.
slow='--set integrator.method=moreau --set integrator.step=4e-5 --set scene.duration=1 --vary initial.psi_dot=150:240:16'
sweep $slow --quiet --out slow.tsv
succeeds
for victim in 0 2 mpirun; do
  command="mpirun contensou sweep, $victim ended"
  rm -f killed.tsv pid_*
  # Each process leaves its number.
  timeout 60 "$mpirun" --quiet --oversubscribe -n 3 sh -c 'echo $$ >pid_$OMPI_COMM_WORLD_RANK; exec "$0" "$@"' \
    "$program" sweep top.toml $slow --quiet --out killed.tsv >out 2>err &
  job=$!
  for i in $(seq 100); do
    [ -e killed.tsv ] && [ "$(rows killed.tsv)" -ge 3 ] && break
    sleep 0.1
  done
  case $victim in
    mpirun) kill -INT $job ;; # as Ctrl-C: timeout passes it on
    *) kill -KILL "$(cat pid_$victim)" ;;
  esac
  status=0
  wait $job || status=$?
  check "exit status $status, expected a failure and no timeout" [ "$status" -ne 0 -a "$status" -ne 124 ]
  check "not cut short" [ "$(rows killed.tsv)" -lt 16 ]
  ranks 3 top.toml $slow --quiet --out killed.tsv
  succeeds
  check "another result after $victim ended" same slow.tsv killed.tsv
done

finish
