# contensou effects: the table of what runs says what the scene says.
. "$(dirname "$0")/check.sh"
exec </dev/null
scene=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml

# effect WHERE EFFECT RUNS ROWS HOW: the table just printed has this row; HOW is a part of its last column.
effect() {
  checks=$((checks + 1))
  awk -F '\t' -v where="$1" -v effect="$2" -v runs="$3" -v rows="$4" -v how="$5" '
    $1 == where && $2 == effect { found = 1; if ($3 != runs || $4 != rows || index($5, how) == 0) { print "got: " $0; exit 1 } }
    END { if (!found) { print "no row " where " " effect; exit 1 } }' "$folder/out" || fail "$1 $2: expected $3 $4 $5"
}
effects() {
  run effects "$scene" "$@"
  succeeds
  check "columns" [ "$(grep -v '^#' "$folder/out" | head -n 1 | tr '\t' ' ')" = 'where effect runs rows how' ]
  check "a row without five cells" awk -F '\t' '!/^#/ && NF != 5 { exit 1 }' "$folder/out"
}

effects
effect scene gravity yes 0 9.81
effect scene 'gyroscopic terms' yes 0 ''
effect scene 'air drag' no 0 ''
effect scene loads no 0 ''
effect scene 'driven bodies' no 0 ''
for contact in body tip; do
  effect contact.$contact 'unilateral contact' yes 1 ''
  effect contact.$contact restitution no 0 ''
  effect contact.$contact 'sliding friction' yes 2 'mu = 0.3'
  effect contact.$contact 'drilling friction' yes 1 'hertz in closed form'
  effect contact.$contact 'coupling of sliding and drilling' yes 0 ball
  effect contact.$contact 'load-dependent radius' no 0 'constant, 5e-04'
  check "rows of $contact" grep -qx "# rows of $contact: 4 of 4, N T1 T2 tau" "$folder/out"
done
effect integrator method yes 0 event_driven
effect integrator step no 0 'chooses its steps'
effect integrator tolerance yes 0 1e-10
effect integrator 'search for stick and slip' yes 0 ''
effect integrator 'search for reversed spin' yes 0 ''

effects --set contact.body.radius=0 --set contact.tip.pressure=power:2 --set contact.tip.restitution=0.5
effect contact.body 'sliding friction' yes 2 'friction disk'
effect contact.body 'drilling friction' no 0 'radius 0'
effect contact.tip 'drilling friction' yes 1 'compiled from power:2'
effect contact.tip restitution yes 0 'e = 0.5'
check "rows of body" grep -qx '# rows of body: 3 of 4, N T1 T2' "$folder/out"

effects --unset contact.body --unset contact.tip --set contact.body.law=frictionless --set 'contact.tip={law="coulomb", mu=0.1}' \
  --set integrator.method=moreau --set scene.gravity=0
effect scene gravity no 0 ''
effect contact.body 'sliding friction' no 0 'frictionless'
effect contact.body 'drilling friction' no 0 ''
effect contact.tip 'drilling friction' no 0 coulomb
effect integrator step yes 0 1e-04
effect integrator tolerance no 0 ''
effect integrator 'search for stick and slip' no 0 'each step'
check "left out" grep -q '^# left out: .*gravity.*sliding friction (body)' "$folder/out"

# Bad scenes are refused as by simulate.
run effects nosuch.toml;                             refused nosuch.toml 'cannot be read'
run effects "$scene" --set contact.body.mu=-1;       refused contact.body.mu -1 'number >= 0'
run effects "$scene" --out somewhere;                refused --out --audit
run effects "$scene" --audit --repeat 0;             refused repeat 0 1
finish
