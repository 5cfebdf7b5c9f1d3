# contensou law: bad input. One line that names where it stood, the value and what was expected; status 2; no table.
. "$(dirname "$0")/check.sh"
exec </dev/null

# Options.
run law 1;                                      refused --pressure required
run law --pressure;                             refused --pressure value
run law --pressure uniform --nosuch 1;          refused '"--nosuch"' 'not an option'
run law --pressure uniform -x 1;                refused '"-x"' 'not an option'
run law --pressure uniform --pressure hertz 1;  refused --pressure 'one value'
run nosuch;                                     refused '"nosuch"' 'expected' 'law'
run --nosuch;                                   refused '"--nosuch"' 'not an option'

# Pressures and models.
for pressure in nosuch '' -1 Uniform power power: power:abc power:nan power:inf power:-1 power:-2 'power:1 ' power:1e999; do
  run law --pressure "$pressure" 1
  refused --pressure "$pressure" expected
done
for model in nosuch '' Exact series: series:0 series:-1 series:1.5 series:abc tanh tanh: tanh:0 tanh:-1 tanh:nan; do
  run law --pressure uniform --model "$model" 1
  refused --model "$model" expected
done
run law --pressure power:1 --model printed 1;   refused --model power:1 expected

# Values of u; a good one before does not help.
for u in -1 -1e-300 -.5 -inf; do
  run law --pressure uniform 1 "$u"
  refused "\"$u\"" 'negative' '>= 0'
done
for u in nan -nan NaN; do
  run law --pressure uniform 1 "$u"
  refused "\"$u\"" 'expected' '>= 0'
done
for u in abc '' ' ' 1,5 1x 0x10 1e 1..2 '1 2' '[1,2]' '{}' +-1; do
  run law --pressure hertz 1 "$u"
  refused "\"$u\"" 'expected'
done
run law --pressure uniform 1 1e999;             refused 'number 2' '"1e999"' range '>= 0'
run law --pressure uniform 1e-999;              refused '"1e-999"' range
run law --pressure uniform '1
2';                                             refused '"1\x0a2"' 'not a number'

# Standard input: the line is named, comments and blank lines counted.
refuses_input() { # TEXT WORD...
  printf "$1" >"$folder/in"
  shift
  run law --pressure uniform <"$folder/in"
  refused "$@"
}
refuses_input ''                    'standard input' 'no values' expected
refuses_input '# only\n\n'          'standard input' 'no values' expected
refuses_input '1\n# c\n\nabc\n2\n'  'standard input:4' '"abc"' '>= 0'
refuses_input '1\n-1\n'             'standard input:2' '"-1"' '>= 0'
refuses_input '1\nnan\n'            'standard input:2' '"nan"' '>= 0'
refuses_input '1e999\n'             'standard input:1' '"1e999"' range
refuses_input '1 2\n'               'standard input:1' '"1 2"' '>= 0'
refuses_input '1 # one\n'           'standard input:1' '"1 # one"' '>= 0'

# Places that take no file. Nothing is left behind, and a device is not replaced by a file.
for place in /dev/null/law.tsv /proc/nosuch/law.tsv "$folder" /dev/null ''; do
  run law --pressure uniform --out "$place" 1
  refused --out "\"$place\"" expected
done
check "/dev/null is no device any more" [ -c /dev/null ]
run law --pressure uniform --out "$folder/never.tsv" 1 abc
refused '"abc"'
check "a table was written" [ ! -e "$folder/never.tsv" ]

# Standard output that takes nothing: status 1, one line.
undelivered() {
  check "exit status $status, expected 1" [ "$status" -eq 1 ]
  check "one line expected: $(cat "$folder/err")" [ "$(wc -l <"$folder/err")" -eq 1 ]
  check "standard output is not named: $(cat "$folder/err")" grep -q 'standard output' "$folder/err"
}
for words in 'law --pressure uniform 1' '--help' 'law --help' '--version'; do
  command="contensou $words, output closed or full"
  for target in '/dev/full' '&-'; do
    status=0
    eval "\"$program\" $words >$target 2>\"$folder/err\"" || status=$?
    undelivered
  done
done

# No subcommand: the help, on standard error.
run
check "exit status $status, expected 2" [ "$status" -eq 2 ]
check "wrote to standard output" [ ! -s "$folder/out" ]
check "no help" grep -q '^Usage: contensou' "$folder/err"

finish
