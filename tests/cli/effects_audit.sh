# contensou effects --audit: each effect off or simplified, its outcomes and times; table and picture.
. "$(dirname "$0")/check.sh"
exec </dev/null
scene=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml
cd "$folder" || exit 1

# cell EFFECT VARIANT CONTACTS OUTCOME COLUMN: of the table just made.
cell() {
  awk -F '\t' -v effect="$1" -v variant="$2" -v contacts="$3" -v outcome="$4" -v name="$5" '
    /^#/ { next }
    !header { for (i = 1; i <= NF; i++) if ($i == name) column = i; header = 1; next }
    $1 == effect && $2 == variant && $3 == contacts && $4 == outcome { print $column }' audit.tsv
}
near() { # near WHAT GOT WANT BOUND
  checks=$((checks + 1))
  awk -v got="$2" -v want="$3" -v bound="$4" 'BEGIN { d = got - want; exit !(got != "" && (d < 0 ? -d : d) <= bound) }' ||
    fail "$1: got $2, expected $3 within $4"
}

# Upright, spinning: drilling friction alone slows it down, and by how much is known (simulate_values.sh). The change between
# two laws is that of omega: (A_1 - A_2) mu m g R T/I3, A = 3 pi/16 (hertz), 2/3 (uniform); nothing for coulomb.
upright="--unset outcome --set initial.theta=0 --set scene.duration=1 --unset contact.tip --set contact.tip.law=frictionless"
run effects "$scene" $upright --audit --repeat 1
succeeds
cp out audit.tsv
change=$(awk 'BEGIN { printf "%.17g", 0.3 * 6e-3 * 9.81 * 5e-4 / 7e-7 }')
hertz=0.5890486225480862
near uniform "$(cell pressure uniform body omega_z change)" "$(awk -v c=$change -v h=$hertz 'BEGIN { printf "%.17g", (2/3 - h) * c }')" 1e-7
near coulomb "$(cell friction coulomb body omega_z change)" "$(awk -v c=$change -v h=$hertz 'BEGIN { printf "%.17g", h * c }')" 1e-7
near frictionless "$(cell friction frictionless body omega_z change)" "$(awk -v c=$change -v h=$hertz 'BEGIN { printf "%.17g", h * c }')" 1e-7
near ellipsoid "$(cell friction ellipsoid body omega_z change)" 0 1e-7
near uncoupled "$(cell friction uncoupled body omega_z change)" 0 1e-7
near "value under coulomb" "$(cell friction coulomb body omega_z value)" 180 1e-7
near "reference" "$(cell friction coulomb body omega_z reference)" "$(awk -v c=$change -v h=$hertz 'BEGIN { printf "%.12g", 180 - h * c }')" 1e-7
near "height without gravity" "$(cell gravity off - z_s change)" 0 1e-9
check "uncoupled is compared with moreau" [ "$(cell friction uncoupled body omega_z compared_with)" = 'method moreau' ]
check "ellipsoid is compared with the scene" [ "$(cell friction ellipsoid body omega_z compared_with)" = scene ]
check "the scene itself" [ "$(cell scene 'as it is' - omega_z change)" = 0 ]
check "its time is its own" [ "$(cell scene 'as it is' - omega_z time_ratio)" = 1 ]
check "the options of a variant" [ "$(cell pressure uniform body omega_z options)" = '--set contact.body.pressure=uniform' ]
check "says that no outcome is named" grep -q '^# the scene names no \[outcome.NAME\]' audit.tsv
check "a row without 15 cells" awk -F '\t' '!/^#/ && NF != 15 { exit 1 }' audit.tsv

# Into a folder: the table and a picture that is well-formed.
run effects "$scene" $upright --set scene.duration=0.1 --audit --repeat 1 --out worth
succeeds
check "says where" grep -q 'audit.tsv, audit.svg in worth' out
check "the table" grep -q '^effect	variant	contacts' worth/audit.tsv
check "the picture" grep -q '^</svg>$' worth/audit.svg
run effects "$scene" $upright --set scene.duration=0.1 --audit --repeat 1 --out worth --quiet
succeeds
check "quiet" [ ! -s out ]

# A variant that fails is a row that says so: a step ten times as long, too long for this printed scheme's doubles.
run effects "$scene" --set scene.duration=0.5 --set integrator.method=rk4_printed --set integrator.step=2e-3 --audit --repeat 1
if [ "$status" -eq 0 ]; then
  cp out audit.tsv
  check "every variant has a status" [ "$(awk -F '\t' '!/^#/ && $14 == ""' audit.tsv | wc -l)" -eq 0 ]
fi

# Places that take no folder.
: >file
run effects "$scene" --audit --out file;           refused --out file 'cannot be written'
finish
