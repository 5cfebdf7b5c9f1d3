# contensou simulate: motions that are known without it, tables as promised, books that add up.
. "$(dirname "$0")/check.sh"
exec </dev/null
scene=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml
cd "$folder" || exit 1

simulate() { # OPTION...: into the folder o, quietly
  rm -rf o
  run simulate "$scene" --quiet --out o "$@"
  succeeds
  check "wrote to standard output" [ ! -s out ]
}
# column NAME: all values of a column of the trajectory.
column() { grep -v '^#' o/trajectory.tsv | awk -F '\t' -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next } { print $c }'; }
# json KEY: the value in summary.json; the first where there are several.
json() { grep -m 1 "\"$1\": " o/summary.json | sed 's/.*: //; s/,$//'; }
# near WHAT GOT WANT BOUND, absolute
near() {
  check "$1 is '$2', expected $3 within $4" awk -v a="$2" -v b="$3" -v e="$4" 'BEGIN {
    d = a - b; exit !(a ~ /^-?[0-9]/ && (d < 0 ? -d : d) <= e) }'
}

# The scene as it ships: tables and summary.
simulate
check "columns" [ "$(grep -v '^#' o/trajectory.tsv | head -n 1 | cut -f 1-7)" = 't	theta	z_s	gap_body	gap_tip	energy	omega_z' ]
check "columns of events" [ "$(grep -v '^#' o/events.tsv | head -n 1)" = 't	event	contact' ]
check "8001 rows" [ "$(column t | wc -l)" -eq 8001 ]
check "not every millisecond" [ "$(column t | awk '{ d = $1 - (NR - 1) / 1000; if (d > 1e-15 * NR || d < -1e-15 * NR) print }' | wc -l)" -eq 0 ]
check "cells that are not finite" [ -z "$(grep -v '^#' o/trajectory.tsv | grep -i -E 'nan|inf')" ]
check "modes" [ -z "$(column mode_body | grep -v -x -E 'open|slip|stick')" ]
check "events" [ -z "$(grep -v '^[#t]' o/events.tsv | grep -v -E '^[0-9.e-]+	(close|open|accumulation|stick|slip)	(body|tip)$')" ]
check "comments name the command" grep -q '^# contensou simulate .*tippe_top.toml, method event_driven' o/trajectory.tsv
for key in method steps wall_seconds evaluations status energy_initial energy_final dissipated effects settings contact_problems \
  iterations worst_residual energy_balance; do
  check "summary.json has no $key" grep -q "^  \"$key\": " o/summary.json
done
check "status" [ "$(json status)" = '"finished"' ]
check "method" [ "$(json method)" = '"event_driven"' ]
check "the setting used" grep -q '"tolerance": 1e-10' o/summary.json
check "the setting not used" [ -z "$(json step)" ]
# At the start: E = I3 psi_dot^2/2 + m g (r1 - a1 cos theta), omega_z = psi_dot cos theta.
near energy "$(column energy | head -n 1)" 0.012047202164495206 1e-17
near omega_z "$(column omega_z | head -n 1)" 179.10074975004464 1e-13
near gap_body "$(column gap_body | head -n 1)" 0 0
# The ledger is the sum of its entries; rounding of six sums.
balance() {
  near "imbalance" "$(json imbalance)" "$(awk -F '[:,]' -v e0="$(json energy_initial)" -v e1="$(json energy_final)" '
    /"(sliding|drilling|impact)":/ { sum += $2 } END { printf "%.17g", e0 - e1 - sum }' o/summary.json)" 1e-16
}
balance
# What is promised of the shipped scene: the books close to 1e-9 of the energy at the start.
near "relative imbalance" "$(json relative)" 0 1e-9

# Free flight with steady spin about its own axis: z = 10 - g t^2/2, theta = 0.1, omega stays. Trapezoid and Runge-Kutta
# steps are exact for it, Euler's velocity is late by half a step, g t h/2. Rounding: 1e4 steps of 10 m * 2^-53: 1e-11.
for case in 'event_driven 1e-11' 'rk4 1e-11' 'moreau 1e-11' 'moreau_adaptive 1e-11' 'rk4_printed 1e-11' 'moreau_printed 1e-11' 'moreau_implicit 5e-4'; do
  simulate --set integrator.method=${case% *} --set initial.z_s=10 --set scene.duration=1 --set output.interval=0.25
  near "z_s, ${case% *}," "$(column z_s | tail -n 1)" \
    "$(column t | tail -n 1 | awk '{ printf "%.17g", 10 - 9.81 / 2 * $1 * $1 }')" "${case#* }"
  near "theta" "$(column theta | tail -n 1)" 0.1 1e-11
  near "omega_z" "$(column omega_z | tail -n 1)" 179.10074975004464 1e-9
  near "imbalance" "$(json imbalance)" 0 "$(awk -v b="${case#* }" 'BEGIN { print 0.06 * 9.81 * b + 1e-13 }')"
  check "events in free flight" [ "$(grep -vc '^[#t]' o/events.tsv)" -eq 0 ]
done

# Upright and spinning, theta = 0: drilling friction alone slows it down, I3 omega' = -A mu m g R with A = 3 pi/16 (hertz),
# 2/3 (uniform), 8/15 (power:1); without a patch nothing does. Constant, so exact for every method: rounding.
spin_down() { # METHOD OMEGA(2) OPTION...
  method=$1 expected=$2
  shift 2
  simulate --set initial.theta=0 --set scene.duration=2 --set output.interval=0.5 --set integrator.method=$method "$@"
  near "omega_z" "$(column omega_z | tail -n 1)" "$expected" 1e-7
  near "dissipated by drilling" "$(json drilling)" "$(awk -v w="$expected" 'BEGIN { printf "%.17g", 3.5e-7 * (180 * 180 - w * w) }')" 1e-10
  near "theta" "$(column theta | tail -n 1)" 0 0
  near "imbalance" "$(json imbalance)" 0 1e-11
}
omega() { awk -v a="$1" 'BEGIN { printf "%.17g", 180 - 2 * a * 0.3 * 6e-3 * 9.81 * 5e-4 / 7e-7 }'; }
for method in event_driven rk4 moreau moreau_adaptive; do
  spin_down $method "$(omega 0.5890486225480862)"
  spin_down $method "$(omega 0.6666666666666667)" --set contact.body.pressure=uniform
done
spin_down event_driven "$(omega 0.5333333333333333)" --set contact.body.pressure=power:1
spin_down event_driven "$(omega 0.5890486225480862)" --set contact.body.model=ellipsoid
spin_down event_driven 180 --set contact.body.radius=0
check "a point contact has 3 rows" [ "$(json rows)" = 3 ]
spin_down event_driven 180 --unset contact.body --set 'contact.body={law="coulomb", mu=0.3}'
spin_down event_driven 180 --unset contact.body --set contact.body.law=frictionless
check "the other contact keeps its friction" grep -q '"rows": 4' o/summary.json

# Dropped 0.05 m with restitution 1/2: touches at t1 = sqrt(2 * 0.05/g), comes to rest at 3 t1, m g 0.05 is gone. Forty
# impacts or so, each located to the tolerance of 1e-10; 1e-7 leaves room for all of their errors.
simulate --set initial.theta=0 --set initial.psi_dot=0 --set initial.z_s=0.062 --set scene.duration=0.5 \
  --set contact.body.restitution=0.5
near "first impact" "$(awk '$2 == "close" { print $1; exit }' o/events.tsv)" 0.1009637554692378 1e-8
near "accumulation" "$(awk '$2 == "accumulation" { print $1; exit }' o/events.tsv)" 0.3028912664077134 1e-7
near "dissipated by impacts" "$(json impact)" 0.002943 1e-9
near "height at rest" "$(column z_s | tail -n 1)" 0.012 1e-12
check "closed at the end" [ "$(column mode_body | tail -n 1)" != open ]

# Both formulations of the attitude tell the same first touch of the stick, to what a tolerance of 1e-10 leaves after 1.4 s: eight digits.
for formulation in axis euler; do
  simulate --set scene.formulation=$formulation --set scene.duration=2
  awk '$2 == "close" { print $1; exit }' o/events.tsv >$formulation
  check "formulation" [ "$(json formulation)" = "\"$formulation\"" ]
done
near "the touch of the stick" "$(cat euler)" "$(cat axis)" 1e-8

# --set and --unset: the last one counts, the file is not touched.
cp "$scene" mine.toml
scene=mine.toml
simulate --set scene.duration=1 --set scene.duration=0.25 --set output.interval=0.125 --unset scene.name
check "the last --set counts" [ "$(column t | tr '\n' ' ')" = '0 0.125 0.25 ' ]
check "the name of the file" [ "$(json scene)" = '"mine"' ]
check "what was set is in the summary" grep -qF '"scene.duration=0.25"' o/summary.json
simulate --unset output.interval --set scene.duration=0.25
check "without interval: start and end" [ "$(column t | tr '\n' ' ')" = '0 0.25 ' ]

finish
