# contensou project: how forces are read, what the table looks like, where it goes, and what a million lines cost.
. "$(dirname "$0")/check.sh"

# The shape: comments, the line of names, one row of six a force, in the order given.
printf '3 4 0\n0.1 0.2 0.3\n0 0 9\n' >"$folder/in"
run project --pressure uniform <"$folder/in"
succeeds
check "column names" [ "$(grep -v '^#' "$folder/out" | head -n 1)" = 'p1	p2	ptau	inside	iterations	residual' ]
check "three rows" [ "$(grep -vc '^[#p]' "$folder/out")" -eq 3 ]
check "six cells in every row" awk -F '\t' '!/^#/ && NF != 6 { exit 1 }' "$folder/out"
check "inside is 0 1 0" [ "$(grep -v '^[#p]' "$folder/out" | cut -f 4 | tr '\n' ' ')" = '0 1 0 ' ]
check "a force inside comes back as it was" \
  [ "$(grep -v '^[#p]' "$folder/out" | sed -n 2p)" = '0.1	0.2	0.3	1	0	0' ]
check "comments name the command" grep -q '^# contensou project --pressure uniform --model exact, version' "$folder/out"
check "comments name the equation" grep -qF '(4.12)' "$folder/out"
check "comments say what inside is" grep -qF 'inside: 1 where' "$folder/out"
cp "$folder/out" "$folder/plain"

# Comments, blank lines, tabs, many blanks, CRLF, plus signs and a last line without an end make no difference.
printf '# l1 l2 ltau\n\n  3\t4   0  \r\n   \n0.1 +0.2 3e-1\n# more\n+0 0.0 9' >"$folder/in"
run project --pressure uniform <"$folder/in"
succeeds
check "other blanks, other table" cmp -s "$folder/out" "$folder/plain"

# Round trip: inside, the digits printed are those of the same doubles.
awk 'BEGIN { srand(12); for (i = 0; i < 500; i++) printf "%.17g %.17g %.17g\n", rand() / 3, rand() / 3, rand() / 3 }' >"$folder/in"
run project --pressure hertz <"$folder/in"
succeeds
check "not inside" [ "$(grep -v '^[#p]' "$folder/out" | cut -f 4 | sort -u)" = 1 ]
check "not the same doubles" [ "$(grep -v '^[#p]' "$folder/out" | cut -f 1-3 | tr '\t' ' ' | paste -d ' ' "$folder/in" - |
  awk '$1 - $4 != 0 || $2 - $5 != 0 || $3 - $6 != 0' | wc -l)" -eq 0 ]

# --out: the same table in the file, an older one replaced, missing folders made, nothing on standard output.
printf '3 4 0\n0.1 0.2 0.3\n0 0 9\n' >"$folder/in"
for file in points.tsv points.tsv new/folder/points.tsv; do
  run project --pressure uniform --out "$folder/$file" <"$folder/in"
  succeeds
  check "wrote to standard output" [ ! -s "$folder/out" ]
  check "$file differs" cmp -s "$folder/$file" "$folder/plain"
done
check "left something behind: $(ls "$folder")" [ "$(ls "$folder" | grep -c 'points.tsv')" -eq 1 ]

# Every model has a table for every pressure it is made for, with six finite cells; inside and out, next to the seam and far.
printf '0 0 0\n0 0 1\n1 0 0\n2 1 3\n0.85 0 0.29\n0.86 0 0.27\n-1e300 1e300 1e300\n1e-300 0 2\n1 1e-300 -1e-300\n' >"$folder/in"
for pressure in uniform hertz power:1 power:-0.5 power:20; do
  for model in exact table:4 table:64 printed series series:1 series:3 series:40 corrected ellipsoid decoupled disk; do
    case $pressure-$model in
      power:*-printed) continue ;; # the paper prints no plate for it
      *-series:1) continue ;; # one term is no plate everywhere
      power:*-series*|power:*-corrected) continue ;; # nor are series of other pressures
    esac
    run project --pressure "$pressure" --model "$model" <"$folder/in"
    succeeds
    check "9 rows expected" [ "$(grep -vc '^[#p]' "$folder/out")" -eq 9 ]
    check "not finite" [ -z "$(grep -v '^[#p]' "$folder/out" | grep -i -E 'nan|inf')" ]
    # 4 ulp of the largest of force and 1: 1e-15 of it
    grep -v '^[#p]' "$folder/out" | tr '\t' ' ' | paste -d ' ' "$folder/in" - >"$folder/both"
    check "the residual is not small" awk '{ l = sqrt(($1 / 1e160)^2 + ($2 / 1e160)^2 + ($3 / 1e160)^2) * 1e160 }
      !($9 + 0 <= 1e-15 * (l > 1 ? l : 1)) { print; exit 1 }' "$folder/both"
  done
done

# Many lines: as many rows.
awk 'BEGIN { srand(1); for (i = 0; i < 100000; i++) print 4 * rand() - 2, 4 * rand() - 2, 2 * rand() - 1 }' >"$folder/in"
run project --pressure hertz <"$folder/in"
succeeds
check "100000 rows expected" [ "$(grep -vc '^[#p]' "$folder/out")" -eq 100000 ]

finish
