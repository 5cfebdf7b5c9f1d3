# What the tests of sweeps share, after check.sh: a scene with outcomes, in the current folder.
#   sweep ARGUMENT...   runs contensou sweep on it
#   results FILE        a sweep's rows without wall_seconds, the one column that differs each time
exec </dev/null
shipped=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml
cd "$folder" || exit 1
# The shipped scene, less its own outcomes.
awk '/^\[/ { ours = $0 !~ /^\[outcome/ } ours || !/./ || (NR < 12)' "$shipped" >top.toml
cat >>top.toml <<'END'

[outcome.inversion]
kind = "crossing"
column = "theta"
value = 1.5707963267948966

[outcome.stick]
kind = "event"
event = "close"
contact = "tip"

[outcome.theta_end]
kind = "final"
column = "theta"
END

sweep() { run sweep top.toml "$@"; }
results() { awk -F '\t' -v OFS='\t' '!/^#/ { NF--; print }' "$1"; }
# same FILE FILE: both have the same results, in the same order.
same() {
  results "$1" >results_1
  results "$2" >results_2
  [ -s results_1 ] && cmp -s results_1 results_2
}
# rows FILE: how many rows there are; a line that was torn counts.
rows() { grep -c '^[0-9]' "$1"; }
