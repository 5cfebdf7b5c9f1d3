# The program explains itself: --help on every level, --version.
. "$(dirname "$0")/check.sh"

run --help
succeeds
for word in 'Usage: contensou' law project simulate effects sweep --version 'Leine' 'Exit status'; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run law --help
succeeds
for word in 'Usage: contensou law' --pressure --model --out uniform hertz power:N exact series ellipsoid 'phi ' 'xi ' \
  'eta ' 'lambda_tau' '[0, inf]' 'standard input' 'Examples' 'Models'; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run project --help
succeeds
for word in 'Usage: contensou project' --pressure --model --out uniform hertz power:N exact table:N series ellipsoid disk \
  'l1 l2 ltau' 'p1 p2 ptau' inside iterations residual 'standard input' 'Examples' 'Models'; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run simulate --help
succeeds
for word in 'Usage: contensou simulate' SCENE --set --unset --out --quiet trajectory.tsv events.tsv summary.json event_driven \
  rk4_printed frictionless coulomb contensou hertz ellipsoid restitution '[integrator]' tolerance step 'Exit status' Examples; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run effects --help
succeeds
for word in 'Usage: contensou effects' SCENE --set --unset --audit --out --repeat --quiet where runs rows how audit.tsv audit.svg \
  uncoupled frictionless restitution Examples; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run sweep --help
succeeds
for word in 'Usage: contensou sweep' SCENE --set --unset --vary KEY=A:B:N:log --out --jobs --restart --quiet wall_seconds \
  '[outcome.NAME]' mpirun Examples; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

# The examples of the help do what they are there for.
scenes=$(cd "$(dirname "$0")/../../scenes" && pwd)
cd "$folder" || exit 1
ln -s "$scenes" scenes
for subcommand in law project simulate effects sweep; do
  run "$subcommand" --help
  # Help is for reading: no line is longer than 120 characters.
  check "a line is too long" awk 'length($0) > 120 { exit 1 }' out
  grep "^  .*contensou $subcommand" out | grep -v mpirun | sed "s|contensou $subcommand|\"$program\" $subcommand|" >examples
  check "three examples expected" [ "$(wc -l <examples)" -ge 3 ]
  while IFS= read -r example; do
    command=$example
    check "does not work" sh -ec "$example" </dev/null >/dev/null
  done <examples
done
check "the example with --out made no file" [ -s law.tsv ]
check "the example with --out made no file" [ -s points.tsv ]
check "the example with --out made no file" [ -s top.tsv ]
check "the example with --out made no folder" [ -s small_radius/summary.json ]
check "the example with --out made no folder" [ -s worth/audit.svg ]

run --version
succeeds
check "version" grep -qE '^contensou [0-9]+\.[0-9]+\.[0-9]+$' "$folder/out"

finish
