# The program explains itself: --help on every level, --version.
. "$(dirname "$0")/check.sh"

run --help
succeeds
for word in 'Usage: contensou' law --version 'Leine' 'Exit status'; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

run law --help
succeeds
for word in 'Usage: contensou law' --pressure --model --out uniform hertz power:N exact series ellipsoid 'phi ' 'xi ' \
  'eta ' 'lambda_tau' '[0, inf]' 'standard input' 'Examples' 'Models'; do
  check "'$word' is missing" grep -qF -e "$word" "$folder/out"
done

# Help is for reading: no line is longer than 120 characters.
check "a line is too long" awk 'length($0) > 120 { exit 1 }' "$folder/out"

# The examples of the help do what they are there for.
cd "$folder" || exit 1
grep '^  .*contensou law' out | sed "s|contensou law|\"$program\" law|" >examples
check "three examples expected" [ "$(wc -l <examples)" -eq 3 ]
while IFS= read -r example; do
  command=$example
  check "does not work" sh -ec "$example" </dev/null >/dev/null
done <examples
check "the example with --out made no file" [ -s law.tsv ]

run --version
succeeds
check "version" grep -qE '^contensou [0-9]+\.[0-9]+\.[0-9]+$' "$folder/out"

finish
