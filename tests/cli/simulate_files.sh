# contensou simulate: where results go, all of them or none; what is said on a terminal; runs that do not reach their end.
. "$(dirname "$0")/check.sh"
exec </dev/null
scene=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml
cd "$folder" || exit 1
results='events.tsv
summary.json
trajectory.tsv'

# A folder named after the scene, in the current folder; one closing line.
run simulate "$scene" --set scene.duration=0.5
succeeds
check "what is in tippe_top: $(ls tippe_top)" [ "$(ls tippe_top)" = "$results" ]
check "one line on standard output" [ "$(wc -l <out)" -eq 1 ]
check "the line: $(cat out)" grep -q '^0\.5 s of motion in .* s: trajectory.tsv, events.tsv, summary.json in tippe_top$' out

# --out: folders are made; older results replaced, other files left alone; --quiet says nothing.
echo mine >tippe_top/notes
run simulate "$scene" --set scene.duration=0.25 --quiet --out tippe_top
succeeds
check "said something" [ ! -s out ]
check "not replaced" [ "$(tail -n 1 tippe_top/trajectory.tsv | cut -f 1)" = 0.25 ]
check "another file was touched" [ "$(cat tippe_top/notes)" = mine ]
run simulate "$scene" --set scene.duration=0.25 --quiet --out new/folder/deep/
succeeds
check "what is in new/folder/deep" [ "$(ls new/folder/deep)" = "$results" ]

# A disk that fills up, a place that is taken: status 1, one line, and the old results stay whole.
undelivered() { # WORD
  check "exit status $status, expected 1" [ "$status" -eq 1 ]
  check "one line expected: $(cat err)" [ "$(wc -l <err)" -eq 1 ]
  check "'$1' is missing: $(cat err)" grep -qF "$1" err
}
cp -r tippe_top kept
command='contensou simulate, files of at most 4 KiB'
status=0
(trap '' XFSZ; ulimit -f 8; exec "$program" simulate "$scene" --set scene.duration=0.5 --quiet --out tippe_top >out 2>err) || status=$?
undelivered 'trajectory.tsv: cannot be written'
check "old results changed" diff -r kept tippe_top
mkdir -p taken/summary.json
run simulate "$scene" --set scene.duration=0.5 --quiet --out taken
undelivered 'summary.json: cannot be written'
check "half of the results: $(ls taken)" [ "$(ls taken)" = summary.json ]
status=0
"$program" simulate "$scene" --set scene.duration=0.25 --out full >/dev/full 2>err || status=$?
undelivered 'standard output'

# A disk that is really full, and one that cannot be written, where a mount of our own is allowed. Only the folder that was
# made may be left; one that is read-only is said before the run (which would take an hour).
mkdir -p disk
if unshare -m mount -t tmpfs -o size=64k none disk 2>err; then
  command='contensou simulate, on a full disk'
  status=0
  unshare -m sh -c 'mount -t tmpfs -o size=64k none disk && "$1" simulate "$2" --set scene.duration=0.1 --quiet --out disk/old 2>first &&
    cp -r disk/old kept_old && "$1" simulate "$2" --set scene.duration=2 --quiet --out disk/old >out 2>err; echo $? >status
    diff -r disk/old kept_old >difference; "$1" simulate "$2" --set scene.duration=2 --quiet --out disk/new 2>again; echo $? >>status
    find disk/new -type f >left' - "$program" "$scene" || status=$?
  check "what was said: $(cat first err again)" [ "$(cat first)$(wc -l <err)$(wc -l <again)" = 11 ]
  check "exit status: $(cat status)" [ "$(cat status | tr '\n' ' ')" = '1 1 ' ]
  check "no file is named: $(cat err)" grep -q 'trajectory.tsv: cannot be written' err
  check "old results changed: $(cat difference)" [ ! -s difference ]
  check "left: $(cat left)" [ ! -s left ]
  command='contensou simulate, on a read-only disk'
  status=0
  unshare -m sh -c 'mount -t tmpfs -o ro none disk && exec "$1" simulate "$2" --set integrator.method=moreau --set integrator.step=1e-8 \
    --out disk/new >out 2>err' - "$program" "$scene" || status=$?
  refused --out '"disk/new"' 'cannot be written'
fi

# Interrupted in the middle: nothing is left, not even the folder.
command='contensou simulate, interrupted'
status=0
timeout -s INT 0.5 "$program" simulate "$scene" --set integrator.method=moreau --set integrator.step=1e-8 --out gone >out 2>err || status=$?
check "exit status $status, expected that of timeout" [ "$status" -eq 124 ]
check "left something" [ ! -e gone ]

# A run that does not reach its end: what there is is written, one line says why, and so does summary.json. Spinning at
# 1e200 rad/s, the square of which is no double.
run simulate "$scene" --set initial.psi_dot=1e200 --set integrator.method=moreau --out unfinished
undelivered 'at t = 0 of 8 s'
check "what is in unfinished" [ "$(ls unfinished)" = "$results" ]
why=$(sed 's/contensou simulate: \([a-z_]*\) at.*/\1/' err)
check "status $why" [ "$why" != finished ]
check "another status in summary.json" grep -q "\"status\": \"$why\"" unfinished/summary.json
check "a number that is none" grep -q '"energy_initial": null' unfinished/summary.json
check "wrote to standard output" [ ! -s out ]

# Contact problems that were not solved to the tolerance are said, though the run reached its end.
run simulate "$scene" --set integrator.method=moreau_printed --set integrator.solver_tolerance=1e-300 --set scene.duration=0.05 --out doubtful
check "exit status $status, expected 0" [ "$status" -eq 0 ]
check "not said: $(cat err)" grep -q 'not converged' err
check "not in the summary" grep -q '"message": ".*not converged' doubtful/summary.json

# On a terminal: progress of a long run, gone at the end; none with --quiet.
if script -qec true /dev/null >/dev/null 2>&1; then
  long="simulate '$scene' --set integrator.method=moreau --set integrator.step=2e-6 --set scene.duration=1 --out long"
  command="contensou $long, on a terminal"
  script -qec "'$program' $long" /dev/null >terminal
  check "no progress: $(head -c 300 terminal)" grep -q 't = 0\.[0-9]* of 1 s, [0-9]* %, [0-9]* s left' terminal
  script -qec "'$program' $long --quiet" /dev/null >terminal
  check "not quiet: $(head -c 300 terminal)" [ ! -s terminal ]
fi

finish
