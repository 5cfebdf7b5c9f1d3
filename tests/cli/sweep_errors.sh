# contensou sweep: bad grids, bad points, places that take no table. One line, status 2, before any run; nothing written.
. "$(dirname "$0")/check.sh"
. "$(dirname "$0")/sweep_common.sh"
: >out; : >err; : >after; : >before
ls >before

# refuses WORD... -- ARGUMENT...
refuses() {
  words=
  while [ "$1" != -- ]; do
    words="$words $1"
    shift
  done
  shift
  sweep --out never.tsv "$@"
  refused $words
}

# Arguments.
run sweep;                                refused SCENE required
run sweep top.toml;                       refused --vary required
run sweep nosuch.toml --vary a=1;         refused nosuch.toml 'cannot be read'
sweep --nosuch;                           refused '"--nosuch"' 'not an option'
for jobs in 0 -1 two 1.5 '' 1025 99999999999; do
  refuses --jobs expected -- --vary contact.body.mu=0.1,0.2 --jobs "$jobs"
done

# Grids.
for vary in contact.body.mu =1 '' contact.body.mu= contact.body.mu=0:1 contact.body.mu=0:1:1 contact.body.mu=0:1:2:lin \
  contact.body.mu=0:1:3:log contact.body.mu=0.1,0.1 contact.body.mu=0.1,; do
  refuses --vary expected -- --vary "$vary"
done
refuses --vary twice -- --vary contact.body.mu=0.1,0.2 --vary contact.body.mu=0.3
refuses --vary undo  -- --vary contact.body.mu=0.1,0.2 --vary 'contact.body={law="frictionless"}'
refuses 1000000      -- --vary contact.body.mu=0:1:1001 --vary contact.tip.mu=0:1:1001

# Points, the first that is bad, though the others are good: what is wrong with it, and which it is.
refuses 'run 0 ' --vary contact.body.nosuch unknown -- --vary contact.body.nosuch=1,2
refuses 'run 3 ' contact.body.mu=-0.1 --vary contact.body.mu -0.1 '>=' -- --vary contact.body.mu=0.2:-0.5:8
refuses 'run 6 ' initial.theta=3.2 contact.tip.mu=0.2 --vary initial.theta 'from 0 to pi' -- \
  --vary initial.theta=0.1,1,2,3.2 --vary contact.tip.mu=0.2,0.1
refuses 'run 1 ' '"nosuch"' event_driven -- --vary integrator.method=moreau,nosuch
refuses 'run 0 ' 'no key' -- --vary 'a b=1'
# Two values each good, not together: lying on its side, the top's centre is higher than this.
refuses 'run 2 ' 'into the floor' -- --vary initial.theta=0.1,1.5 --vary initial.z_s=0.0121,0.02

# Outcomes: one with the name of another column.
refuses outcome.status name -- --set 'outcome.status={kind="final",column="theta"}' --vary contact.body.mu=0.1,0.2

# Places.
for place in '' . /dev/null top.toml/x; do
  run sweep top.toml --set scene.duration=0.01 --vary contact.body.mu=0.1,0.2 --out "$place"
  refused --out "\"$place\"" expected
done

ls >after
check "left behind: $(diff before after | tr '\n' ' ')" cmp -s before after

finish
