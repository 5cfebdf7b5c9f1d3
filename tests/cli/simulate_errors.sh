# contensou simulate: bad scenes, bad overrides, places that take no folder. One line that names file and line, or the key,
# the value and what was expected; status 2; nothing written.
. "$(dirname "$0")/check.sh"
exec </dev/null
shipped=$(cd "$(dirname "$0")/../../scenes" && pwd)/tippe_top.toml
cd "$folder" || exit 1
cp "$shipped" good.toml
: >out; : >err; : >after; : >before
ls >before

# at PATTERN: good.toml's first line like this, as it will be named in bad.toml.
at() { echo "bad.toml:$(grep -n -m 1 -e "$1" good.toml | cut -d : -f 1): "; }

# refuses SED WORD...: good.toml, changed by a sed script, is refused.
refuses() {
  sed -e "$1" good.toml >bad.toml
  cmp -s good.toml bad.toml && fail "the change '$1' changes nothing"
  shift
  run simulate bad.toml --out never
  refused "$@"
}
# overrides_to KEY=VALUE WORD...: so is good.toml with --set.
overrides_to() {
  run simulate good.toml --out never --set "$1"
  shift
  refused "$@"
}

# Arguments.
run simulate;                                      refused SCENE required
run simulate good.toml good.toml;                  refused '"good.toml"' 'not expected' --help
run simulate good.toml --nosuch;                   refused '"--nosuch"' 'not an option'
run simulate good.toml -1;                         refused '"-1"' 'not expected'
run simulate good.toml --set;                      refused --set value
run simulate good.toml --out;                      refused --out value
run simulate good.toml --out a --out b;            refused --out 'one value'

# Files that are no scene.
run simulate nosuch.toml;                          refused nosuch.toml 'cannot be read' 'expected a scene'
run simulate .;                                    refused . 'cannot be read' 'expected a scene'
run simulate '';                                   refused 'cannot be read' 'expected a scene'
head -c 2000000 /dev/zero | tr '\0' '#' >long.toml
run simulate long.toml;                            refused long.toml 1048576 'expected a scene'
: >empty.toml
run simulate empty.toml --out never;               refused empty.toml 'scene.system is missing' '"tippe_top"'
for text in 'a' 'a = ' 'a = 1 2' '[a' 'a = "b' 'a = 1\na = 2' '[a]\n[a]' 'a = 01' 'a = "\001"' 'a = [1' '= 1' 'a..b = 1'; do
  printf "[scene]\n$text\n" >bad.toml
  run simulate bad.toml --out never
  checks=$((checks + 1))
  refused bad.toml: 'expected'
  check "no line number: $(cat err)" grep -qE 'bad\.toml:[23]: ' err
done

printf 'a = 1\n\377 = 1\n' >bad.toml
run simulate bad.toml --out never;                 refused bad.toml: utf-8 expected

# Nesting that would break a parser that goes down with it.
awk 'BEGIN { printf "a"; for (i = 0; i < 500000; i++) printf ".a"; print " = 1" }' >bad.toml
run simulate bad.toml --out never;                 refused bad.toml:1 '100 parts'
awk 'BEGIN { printf "\n[a"; for (i = 0; i < 100000; i++) printf " . \"=\""; print "]" }' >bad.toml
run simulate bad.toml --out never;                 refused bad.toml:2 '100 parts'
awk 'BEGIN { printf "a = "; for (i = 0; i < 100000; i++) printf "["; print "" }' >bad.toml
run simulate bad.toml --out never;                 refused bad.toml:1 'expected'
echo 'a.b.c.d.e.f.g.h.i.j = 1' >bad.toml
run simulate bad.toml --out never;                 refused bad.toml:1 'nested deeper than 8'

# Unknown keys: the line, the value, and what there is; the first in the file.
refuses 's/^gravity/gravitation/'      "$(at '^gravity')scene.gravitation" 9.81 unknown gravity duration
refuses 's/^mass/m/'                   "$(at '^mass')top.m" 0.006 unknown 'mass'
refuses 's/\[contact.tip\]/[contact.tap]/' contact.tap.law unknown '[contact.tip]'
refuses '1i x = 1'                     'bad.toml:1: x' unknown '[scene]'
refuses '$a [nosuch]'                  nosuch unknown '[scene]'
refuses '$a "interval.x" = 1'          'output."interval.x"' unknown interval
refuses '$a [[contact.body.x]]'        'bad.toml'
overrides_to contact.body.nosuch=1     '--set contact.body.nosuch' unknown 1 mu radius
overrides_to contact.body.mu.x=1       '--set contact.body.mu.x' unknown
overrides_to scene='{nosuch=3}'        '--set scene.nosuch' unknown 3

# Missing keys, each of them.
for key in scene.system scene.duration scene.gravity top.mass top.i1 top.i3 top.a1 top.a2 top.r1 top.r2 initial.theta \
  initial.psi_dot initial.z_s contact.body.law contact.body.mu contact.body.radius contact.tip.law contact.tip.mu \
  contact.tip.radius integrator.method integrator.tolerance; do
  run simulate good.toml --out never --unset $key
  refused good.toml $key missing expected
done
run simulate good.toml --out never --unset integrator.step --set integrator.method=moreau
refused good.toml integrator.step missing 'a number > 0'
run simulate good.toml --out never --unset contact.tip;  refused contact.tip.law missing frictionless coulomb contensou

# Numbers that are none, or none that make sense.
positive='scene.duration top.mass top.i1 top.i3 top.r1 top.r2 integrator.tolerance integrator.step integrator.solver_tolerance output.interval'
not_negative='scene.gravity contact.body.mu contact.tip.mu contact.body.radius contact.tip.radius contact.body.restitution contact.tip.restitution'
finite='top.a1 top.a2 initial.theta initial.psi_dot'
for key in $positive $not_negative $finite; do
  for value in nan -nan inf -inf abc true '[1]' '"1"' 2020-01-01 '{a=1}' '' '1 # one' '1,2' 0x 1e; do
    run simulate good.toml --out never --set "$key=$value"
    case $value in
      '{a=1}') refused "--set $key.a" unknown ;;
      *) refused "--set $key" "$value" expected ;;
    esac
  done
done
for key in $positive $not_negative; do
  overrides_to $key=-1e-3  "--set $key" -1e-3 'out of range' 'expected a number'
done
for key in $positive; do
  overrides_to $key=0      "--set $key" 'out of range' '> 0'
done
for key in contact.body.restitution contact.tip.restitution; do
  overrides_to $key=1.001  "--set $key" 1.001 'from 0 to 1'
done
overrides_to initial.theta=-0.1           '--set initial.theta' -0.1 'from 0 to pi'
overrides_to initial.theta=3.15           '--set initial.theta' 3.15 'from 0 to pi'
overrides_to top.i3=1.7e-6                '--set top.i3' 1.7e-6 '2 i1'
overrides_to output.interval=1e-6         '--set output.interval' 1e-6 '1e6'
run simulate good.toml --out never --set integrator.method=moreau --set integrator.step=1e-12
refused '--set integrator.step' 1e-12 duration/1e12
refuses 's/^mass *= 6e-3/mass = "heavy"/' "$(at '^mass')top.mass" '"heavy"' 'not a number'
refuses 's/^mu *= 0.3/mu = -0.3/'         "$(at '^mu')contact.body.mu" -0.3 '>= 0'

# Words.
overrides_to scene.system=spinning_top    '--set scene.system' '"spinning_top"' '"tippe_top"'
overrides_to scene.formulation=quaternion '--set scene.formulation' '"quaternion"' axis euler
overrides_to scene.name=3                 '--set scene.name' 3 'a string'
overrides_to integrator.method=euler      '--set integrator.method' '"euler"' rk4_printed event_driven
overrides_to integrator.method=4          '--set integrator.method' 4 'not a string'
for contact in body tip; do
  overrides_to contact.$contact.law=Coulomb     "--set contact.$contact.law" '"Coulomb"' coulomb
  overrides_to contact.$contact.model=series    "--set contact.$contact.model" '"series"' exact ellipsoid
  for pressure in parabolic power power: power:-1 power:nan power:1e7 ''; do
    overrides_to contact.$contact.pressure=$pressure "--set contact.$contact.pressure" "\"$pressure\"" expected
  done
done

# Keys that the law or the method does not use.
overrides_to contact.body.law=coulomb      contact.body.pressure '"hertz"' 'not used by law coulomb' '--unset contact.body.pressure'
run simulate good.toml --out never --unset contact.body.pressure --set contact.body.law=coulomb
refused contact.body.radius 5e-04 'not used by law coulomb'
overrides_to contact.tip.law=frictionless  contact.tip.mu 0.3 'not used by law frictionless'
run simulate good.toml --out never --set 'contact.tip={law="coulomb", mu=0.3, model="exact"}'
refused '--set contact.tip.model' '"exact"' 'not used by law coulomb'
overrides_to integrator.r=1                '--set integrator.r' 'not used by method event_driven'

# A start within the floor, and where Euler angles have none. Touching is at 0.015 - 0.003 cos(0.1) = 0.012014987...
overrides_to initial.z_s=0.012             '--set initial.z_s' 0.012 'into the floor' '"contact"' 0.0120149875
overrides_to initial.z_s=-1                '--set initial.z_s' -1 'into the floor'
overrides_to initial.z_s=touching          '--set initial.z_s' '"touching"' '"contact"'
run simulate good.toml --out never --set scene.formulation=euler --set initial.theta=0
refused '--set initial.theta' singular axis

# Scenes of bodies: one of each kind; all of them are in tests/scene.
cp "$(dirname "$shipped")/tippe_top_bodies.toml" "$(dirname "$shipped")/pile.toml" .
bodies() { # SCENE KEY=VALUE WORD...
  scene=$1
  run simulate "$scene" --out never --set "$2"
  shift 2
  refused "$@"
}
bodies tippe_top_bodies.toml body.top.mass=-1         '--set body.top.mass' -1 '> 0'
bodies tippe_top_bodies.toml body.top.inertia=[1,1,3] '--set body.top.inertia' '[1,1,3]' 'sum of the others'
bodies tippe_top_bodies.toml body.top.inertia=[1,1]   '--set body.top.inertia' '2 entries'
bodies tippe_top_bodies.toml body.top.orientation=[1,1,0,0] '--set body.top.orientation' 'length 1.41' quaternion
bodies tippe_top_bodies.toml body.top.position=[0,nan,0] '--set body.top.position' 'holds nan'
bodies tippe_top_bodies.toml body.top.touching=flor   '--set body.top.touching' '"flor"' 'a plane'
bodies tippe_top_bodies.toml 'load.push={body="tip", force=[0,0,1]}' '--set load.push.body' '"tip"'
bodies tippe_top_bodies.toml integrator.method=nscd   'gap_body' 'no column here'
bodies pile.toml 'contact.glass.between=["marbles", "galss"]' '--set contact.glass.between' '"galss"' 'marbles, glass'
bodies pile.toml 'contact.glass.between=["marbles", "marbles"]' '--set contact.glass.between' 'contact marbles'
bodies pile.toml balls.marbles.spacing=0.0199          '--set balls.marbles.spacing' '2 radius'
bodies pile.toml 'balls.marbles.lower=[0.009, 0.009, 0.009]' '--set balls.marbles.lower' 'deep into glass.'
bodies pile.toml balls.marbles.count=1e300             '--set balls.marbles.count' 1e300 1000000
bodies pile.toml box.glass.sides=[]                    '--set box.glass.sides' '"bottom"'
bodies pile.toml output.columns=[]                     '--set output.columns'
bodies pile.toml integrator.method=moreau              '--set integrator.method' 'pairs' nscd
run simulate pile.toml --out never --unset contact.glass.mu
refused "pile.toml:$(grep -n -F '[contact.glass]' pile.toml | cut -d : -f 1): contact.glass.mu is missing"
rm tippe_top_bodies.toml pile.toml

# --set and --unset themselves.
for assignment in abc '' =1 'a b=1' '.=1' 'a.=1' '.a=1' 'a..b=1' '"a"=1' 'é=1'; do
  overrides_to "$assignment" --set expected
done
for value in '"abc' "'abc" '[1' '{a=1' '"a" x'; do
  overrides_to "contact.body.mu=$value" '--set contact.body.mu' 'none'
done
overrides_to "contact.body.mu=$(printf '0.3\nx=1')" '--set contact.body.mu' '"0.3\x0ax=1"' 'not a number'
for key in nosuch contact.body.nosuch contact.bod '' . a..b 'a b'; do
  run simulate good.toml --out never --unset "$key"
  refused --unset expected
done
run simulate good.toml --out never --unset contact.body.mu --unset contact.body.mu
refused --unset contact.body.mu 'not in the scene'

# Places that take no folder, said before the run.
: >file
for place in '' file file/x /dev/null /dev/null/x good.toml; do
  run simulate good.toml --out "$place"
  refused --out "\"$place\"" 'expected the name of a folder'
done
mkdir there && cp good.toml there && cd there && mv good.toml tippe && : >tippe_top
run simulate tippe
refused '"tippe"' 'expected the name of a folder'
cd ..

rm -rf there file bad.toml long.toml empty.toml
ls >after
check "left behind: $(diff before after | tr '\n' ' ')" cmp -s before after

finish
