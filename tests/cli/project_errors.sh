# contensou project: bad input. One line that names where it stood, the value and what was expected; status 2; no table.
. "$(dirname "$0")/check.sh"
echo 1 2 3 >"$folder/good"

# Options and arguments.
run project <"$folder/good";                               refused --pressure required
run project --pressure <"$folder/good";                    refused --pressure value
run project --pressure uniform --nosuch <"$folder/good";   refused '"--nosuch"' 'not an option'
run project --pressure uniform 1 2 3 <"$folder/good";      refused '"1"' 'not expected' --help
run project --pressure uniform -1 <"$folder/good";         refused '"-1"' 'not expected' --help
run project --pressure uniform x.txt <"$folder/good";      refused '"x.txt"' 'not expected' --help
run project --pressure uniform --model exact --model disk <"$folder/good"; refused --model 'one value'

# Pressures and models.
for pressure in nosuch '' -1 Uniform power power: power:abc power:nan power:inf power:-1 power:1e999; do
  run project --pressure "$pressure" <"$folder/good"
  refused --pressure "$pressure" expected
done
for model in nosuch '' Exact series: series:0 series:-1 series:1.5 series:41 series:abc table table: table:3 table:257 \
  table:1.5 table:abc; do
  run project --pressure uniform --model "$model" <"$folder/good"
  refused --model "$model" expected
done
run project --pressure power:1 --model printed <"$folder/good"; refused --model power:1 expected
# Laws that are no ball's: said, and why.
for model in pade pade2 tanh:0.01; do
  run project --pressure uniform --model "$model" <"$folder/good"
  refused --model "$model" 'no friction ball'
done

# Series that are no plate, tables too coarse: both options are named.
for pair in 'uniform series:1' 'power:20 series:3' 'power:101 series:40' 'power:1e6 table:4'; do
  run project --pressure "${pair% *}" --model "${pair#* }" <"$folder/good"
  refused --model "${pair% *}" "${pair#* }"
done

# Standard input: the line is named, comments and blank lines counted; a good line before does not help.
refuses_input() { # TEXT WORD...
  printf "$1" >"$folder/in"
  shift
  run project --pressure hertz <"$folder/in"
  refused "$@"
}
refuses_input ''                        'standard input' 'no values' 'l1 l2 ltau'
refuses_input '# only\n\n'              'standard input' 'no values' 'l1 l2 ltau'
refuses_input '1\n'                     'standard input:1' '"1"' '1 value;' 'l1 l2 ltau'
refuses_input '1 2 3\n1 2\n'            'standard input:2' '"1 2"' '2 values' 'l1 l2 ltau'
refuses_input '\n# c\n1 2 3 4\n'        'standard input:3' '"1 2 3 4"' '4 values' 'l1 l2 ltau'
refuses_input '1 2 3 # in\n'            'standard input:1' '"1 2 3 # in"' '5 values' 'l1 l2 ltau'
refuses_input '1,2,3\n'                 'standard input:1' '"1,2,3"' '1 value;' 'l1 l2 ltau'
refuses_input '1, 2, 3\n'               'standard input:1' l1 '"1,"' 'not a number' 'finite number'
refuses_input '1 2 3\n1 abc 3\n4 5 6\n' 'standard input:2' l2 '"abc"' 'not a number' 'finite number'
refuses_input '1 2 3x\n'                'standard input:1' ltau '"3x"' 'not a number' 'finite number'
refuses_input '0x1 2 3\n'               'standard input:1' l1 '"0x1"' 'not a number' 'finite number'
refuses_input '1 2 nan\n'               'standard input:1' ltau '"nan"' 'finite number'
refuses_input '1 -nan 3\n'              'standard input:1' l2 '"-nan"' 'finite number'
refuses_input 'inf 2 3\n'               'standard input:1' l1 '"inf"' 'finite number'
refuses_input '1 2 -inf\n'              'standard input:1' ltau '"-inf"' 'finite number'
refuses_input '1 1e999 3\n'             'standard input:1' l2 '"1e999"' range 'finite number'
refuses_input '1 2 1e-999\n'            'standard input:1' ltau '"1e-999"' range 'finite number'
refuses_input '1 2 \001\n'              'standard input:1' ltau '"\x01"' 'not a number'
refuses_input '1 2 [3]\n'               'standard input:1' ltau '"[3]"' 'not a number'

# Standard input that cannot be read, or is not there.
run project --pressure uniform <"$folder"; refused 'standard input' expected
run project --pressure uniform <&-;        refused 'standard input' expected

# Places that take no file. Nothing is left behind, and a bad line leaves none.
for place in /dev/null/p.tsv /proc/nosuch/p.tsv "$folder" /dev/null ''; do
  run project --pressure uniform --out "$place" <"$folder/good"
  refused --out "\"$place\"" expected
done
check "/dev/null is no device any more" [ -c /dev/null ]
printf '1 2 3\n1 2 abc\n' >"$folder/in"
run project --pressure uniform --out "$folder/never.tsv" <"$folder/in"
refused '"abc"'
check "a table was written" [ ! -e "$folder/never.tsv" ]
echo before >"$folder/kept.tsv"
run project --pressure uniform --out "$folder/kept.tsv" <"$folder/in"
refused '"abc"'
check "an older table was touched" [ "$(cat "$folder/kept.tsv")" = before ]

# Standard output that takes nothing: status 1, one line.
for target in '/dev/full' '&-'; do
  command="contensou project, output $target"
  status=0
  eval "\"$program\" project --pressure uniform <\"$folder/good\" >$target 2>\"$folder/err\"" || status=$?
  check "exit status $status, expected 1" [ "$status" -eq 1 ]
  check "one line expected: $(cat "$folder/err")" [ "$(wc -l <"$folder/err")" -eq 1 ]
  check "standard output is not named: $(cat "$folder/err")" grep -q 'standard output' "$folder/err"
done

finish
