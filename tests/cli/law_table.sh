# contensou law: where u comes from, where the table goes, and what it looks like.
. "$(dirname "$0")/check.sh"

# The shape: comments, the line of names, rows of four in the order asked for.
run law --pressure uniform 2 0.5 1e-320 1.7976931348623157e308 inf
succeeds
check "column names" [ "$(grep -v '^#' "$folder/out" | head -n 1)" = 'u	phi	xi	eta' ]
check "u in the order given, read back to the same double" \
  [ "$(grep -v '^#' "$folder/out" | sed 1d | cut -f 1 | tr '\n' ' ')" = '2 0.5 1e-320 1.7976931348623157e+308 inf ' ]
check "comments name the pressure" grep -q '^# .*--pressure uniform' "$folder/out"
check "comments name the equation" grep -q '^# law: .*LG03 (2.1)' "$folder/out"
check "four cells in every row" awk -F '\t' '!/^#/ && NF != 4 { exit 1 }' "$folder/out"

# Standard input, with comments, blank lines, spaces, CRLF and a last line without an end, is the same as arguments.
run law --pressure hertz 0 0.5 1 2 inf
cp "$folder/out" "$folder/arguments"
printf '# u\n\n0\n  0.5  \n1\r\n\t+2\n   \ninf' >"$folder/in"
run law --pressure hertz <"$folder/in"
succeeds
check "standard input differs from arguments" cmp -s "$folder/out" "$folder/arguments"

# Round trip: the u of a table, fed back, gives the same table; so 17 digits are never needed.
seq -f %.3f 0 0.037 3 >"$folder/in"
run law --pressure uniform <"$folder/in"
cp "$folder/out" "$folder/first"
grep -v '^[#u]' "$folder/first" | cut -f 1 >"$folder/in"
run law --pressure uniform <"$folder/in"
succeeds
check "the round trip differs" cmp -s "$folder/out" "$folder/first"

# Arguments are preferred to standard input, -- ends the options, --option=value works.
echo nonsense >"$folder/in"
run law --pressure=hertz -- 0 0.5 1 2 inf <"$folder/in"
succeeds
check "arguments after -- differ" cmp -s "$folder/out" "$folder/arguments"

# --out: the same table in the file, an older one replaced, missing folders made, nothing on standard output.
for file in law.tsv law.tsv new/folder/law.tsv; do
  run law --pressure hertz --out "$folder/$file" 0 0.5 1 2 inf
  succeeds
  check "wrote to standard output" [ ! -s "$folder/out" ]
  check "$file differs" cmp -s "$folder/$file" "$folder/arguments"
done
check "left something behind: $(ls "$folder")" [ "$(ls "$folder" | grep -c 'law.tsv')" -eq 1 ]

finish
