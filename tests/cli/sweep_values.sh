# contensou sweep: its numbers are those of contensou simulate at the same point; the table; any number of jobs gives the same.
. "$(dirname "$0")/check.sh"
. "$(dirname "$0")/sweep_common.sh"

# The table: comments, the columns, a row each, the last key fastest.
sweep --set scene.duration=2 --vary contact.body.radius=1e-5:1e-3:3:log --vary initial.psi_dot=150:240:4 --out table.tsv
succeeds
check "the closing line: $(cat out)" grep -qE '^12 of 12 runs, 12 of them now in .* s: table\.tsv$' out
check "three comments" [ "$(grep -c '^#' table.tsv)" -eq 3 ]
check "the command: $(head -n 1 table.tsv)" grep -q '^# contensou sweep top.toml .*radius=1e-5:1e-3:3:log.*, version [0-9]' table.tsv
check "the columns" [ "$(sed -n 4p table.tsv | tr '\t' ' ')" = \
  'run contact.body.radius initial.psi_dot inversion stick theta_end status steps wall_seconds' ]
check "12 rows in order" [ "$(grep -v '^#' table.tsv | sed 1d | cut -f 1 | tr '\n' ' ')" = '0 1 2 3 4 5 6 7 8 9 10 11 ' ]
check "the grid" [ "$(grep '^6' table.tsv | cut -f 1-3 | tr '\t' ' ')" = '6 1e-04 210' ]
check "all finished" [ "$(cut -f 7 table.tsv | grep -c '^finished$')" -eq 12 ]

# Run 5 (1e-4, 180) by contensou simulate: its steps, its last theta and the first time its tip touches, to the last digit;
# the inversion between the two rows where theta passes pi/2.
run simulate top.toml --set scene.duration=2 --set contact.body.radius=1e-4 --set initial.psi_dot=180 --quiet --out point
succeeds
at() { awk -F '\t' -v run="$1" -v i="$2" '$1 == run && !/^#/ { print $i }' table.tsv; }
check "theta_end $(at 5 6)" [ "$(at 5 6)" = "$(tail -n 1 point/trajectory.tsv | cut -f 2)" ]
check "stick $(at 5 5)" [ "$(at 5 5)" = "$(awk -F '\t' '$2 == "close" && $3 == "tip" { print $1; exit }' point/events.tsv)" ]
check "steps $(at 5 8)" [ "$(at 5 8)" = "$(sed -n 's/.*"steps": \([0-9]*\),.*/\1/p' point/summary.json)" ]
check "inversion $(at 5 4)" awk -F '\t' -v t="$(at 5 4)" '
  !/^[#t]/ { if (last != "" && last < 1.5707963267948966 && $2 >= 1.5707963267948966) { found = 1; exit !(t >= before && t <= $1) }
             last = $2; before = $1 }
  END { if (!found) exit 1 }' point/trajectory.tsv
check "an inversion by 2 s where there is none" [ "$(at 1 4)" = nan ]

# Where the scene names no outcome: the last values of all columns.
run sweep top.toml --unset outcome --set scene.duration=2 --set contact.body.radius=1e-4 --vary initial.psi_dot=180 --quiet --out last.tsv
succeeds
check "the columns" [ "$(grep '^run' last.tsv | cut -f 3-6)" = "$(grep '^t' point/trajectory.tsv | cut -f 2-5)" ]
check "the values" [ "$(grep '^0' last.tsv | cut -f 3-6)" = "$(tail -n 1 point/trajectory.tsv | cut -f 2-5)" ]

# One job, three jobs: the same but for wall_seconds. --quiet says nothing. Words as values.
for jobs in 1 3; do
  sweep --set scene.duration=2 --vary contact.body.radius=1e-5:1e-3:3:log --vary initial.psi_dot=150:240:4 --jobs $jobs \
    --quiet --out jobs_$jobs.tsv
  succeeds
  check "not quiet" [ ! -s out ]
  check "another result with $jobs jobs" same table.tsv jobs_$jobs.tsv
done
sweep --set scene.duration=0.1 --set integrator.step=1e-3 --vary integrator.method=moreau,moreau_implicit --out words.tsv
succeeds
check "words" [ "$(cut -f 2 words.tsv | tail -n 2 | tr '\n' ' ')" = 'moreau moreau_implicit ' ]

# Named after the scene where nothing is said; folders are made.
sweep --set scene.duration=0.01 --vary contact.body.mu=0.1,0.3 --quiet
succeeds
check "top_sweep.tsv" [ -s top_sweep.tsv ]
sweep --set scene.duration=0.01 --vary contact.body.mu=0.1,0.3 --quiet --out new/folder/mu.tsv
succeeds
check "the same in another place" same top_sweep.tsv new/folder/mu.tsv

# A run that fails is a row, and the others go on: spinning at 1e200 rad/s, the square of which is no double.
run sweep top.toml --set integrator.method=moreau --set scene.duration=0.01 --vary initial.psi_dot=100,1e200,200 --quiet --out fails.tsv
check "exit status $status, expected 0" [ "$status" -eq 0 ]
check "one line: $(cat err)" [ "$(grep -c '^contensou sweep: 1 runs did not reach their end' err)" -eq 1 ]
check "three rows" [ "$(rows fails.tsv)" -eq 3 ]
check "its row: $(grep '^1' fails.tsv)" awk -F '\t' '$1 == 1 && !/^#/ { exit !($3 == "nan" && $4 == "nan" && $5 == "nan" && $6 != "finished" && $6 ~ /^[a-z_]+$/) }' fails.tsv
check "the others" [ "$(cut -f 6 fails.tsv | grep -c '^finished$')" -eq 2 ]

# On a terminal: progress of a long sweep, gone at the end; none with --quiet.
if script -qec true /dev/null >/dev/null 2>&1; then
  long="sweep top.toml --set integrator.method=moreau --set integrator.step=2e-5 --set scene.duration=1 --vary initial.psi_dot=100:200:8 --restart --out long.tsv"
  command="contensou $long, on a terminal"
  script -qec "'$program' $long" /dev/null >terminal
  check "no progress: $(head -c 300 terminal)" grep -q '[1-8] of 8 runs, [0-9]* %, [0-9]* s left' terminal
  script -qec "'$program' $long --quiet" /dev/null >terminal
  check "not quiet: $(head -c 300 terminal)" [ ! -s terminal ]
fi

finish
