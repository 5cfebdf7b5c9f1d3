# The session shown in the README is what the program does: each command with build/bin/contensou is run and its output
# compared word by word, numbers within 1e-13 (relative; an exact 0 has to be 0; what is below 1e-15 is rounding and has to be
# so). Its scene runs as it stands, and the coin stops.
source=$1
program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

awk -v folder="$folder" '
  /^```/ { inside = 0 }
  inside { print > shown }
  /^\$ (.* \| )?build\/bin\/contensou / {
    inside = 1; ++n; shown = folder "/shown" n
    sub(/^\$ /, ""); sub(/build\/bin\/contensou/, "\"$program\""); print > (folder "/command" n)
  }' "$source/README.md"
[ -e "$folder/command1" ] || { echo "README.md shows no session"; exit 1; }

for command in "$folder"/command*; do
  n=${command##*command}
  eval "$(cat "$command")" >"$folder/got$n" || exit 1
  paste -d '\n' "$folder/shown$n" "$folder/got$n" | awk -F '[\t ]' '
    function number(word) { return word ~ /^-?[0-9][0-9.]*(e[-+]?[0-9]+)?$/ }
    function rounding(word) { return number(word) && word + 0 != 0 && word < 1e-15 && word > -1e-15 }
    NR % 2 { count = split($0, shown); line = $0; next }
    {
      bad = NF != count
      for (i = 1; i <= NF && !bad; ++i) {
        if ($i == shown[i] || (rounding($i) && rounding(shown[i]))) continue
        d = $i - shown[i]
        bad = !number($i) || !number(shown[i]) || !((d < 0 ? -d : d) <= 1e-13 * shown[i])
      }
      if (bad) { print "README.md: " line; print "program:   " $0; failed = 1 }
    }
    END { exit failed || NR < 2 }' || exit 1
done

awk '/^```/ { inside = 0 } inside { print } /^```toml/ { inside = 1 }' "$source/README.md" >"$folder/coin.toml"
"$program" simulate "$folder/coin.toml" --out "$folder/coin" --quiet || exit 1
grep -q "$(printf 'stick\tice')" "$folder/coin/events.tsv" || { echo "README.md: the coin does not stop"; exit 1; }
