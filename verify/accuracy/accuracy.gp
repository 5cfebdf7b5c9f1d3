# Accuracy over u: the largest relative error in each tenth of a decade, one column a pressure, one row a quantity.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" accuracy.gp
load style
light = '#dedede'
table = data . '/accuracy_over_u.tsv'
eval panel('accuracy', 940, 1080)

half_ulp = 2.0**-53   # what rounding the exact value can cost: no double can promise less
floor = 1e-17         # smaller errors, and none, are drawn here
set logscale xy
set xrange [1e-9:1e9]
set yrange [4e-19:20]
set xtics 1e-9,1e3,1e9
set ytics 1e-16,1e4,1
unset mxtics
unset mytics
set grid xtics ytics linecolor rgb light linewidth 0.6
set clip one

# Columns of the table: 1 pressure, 2 method, 3 quantity, 4 u, 6 error.
error(pressure, method, quantity) = strcol(1) eq pressure && strcol(2) eq method && strcol(3) eq quantity \
  ? (column(6) > floor ? column(6) : floor) : NaN

array quantity = ['phi', 'xi', 'eta']
array symbol = ['Φ', '{/:Italic ξ}', '{/:Italic η}']
array method = ['textbook_ke_boost', 'carlson_boost', 'printed_series', 'printed', 'exact']
array colour = [green, purple, vermilion, vermilion, blue]

# Labels, row by row, each beside its curve and in its colour.
name(x, y, side, i, text) = sprintf("set label '%s' at %g,%g %s textcolor rgb '%s'", text, x, y, side, colour[i])
array labels = [ \
  name(1e5, 6e-6, 'right', 1, 'textbook K, E') . ';' . name(4e-2, 1e-8, 'right', 3, 'series (2.8)') . ';' . \
  name(1e-5, 1e-14, 'center', 2, 'Carlson'), \
  name(1e5, 6e-6, 'right', 4, '(3.14) as printed'), \
  name(3e-5, 1e-5, 'left', 1, 'K, E') . ';' . name(8, 1e-4, 'left', 3, 'series (2.13)') . ';' . \
  name(1e-6, 8e-14, 'left', 2, 'Carlson'), \
  name(6e4, 6e-6, 'right', 4, '(3.17) as printed'), \
  name(3e4, 1e-1, 'left', 1, 'K, E') . ';' . name(6e-2, 1e-8, 'right', 3, 'series (2.14)') . ';' . \
  name(1e5, 1e-9, 'left', 2, 'Carlson'), \
  name(1e2, 6e-6, 'right', 4, '(3.18) as printed')]

set multiplot
do for [row = 1:3] {
  do for [col = 1:2] {
    pressure = col == 1 ? 'uniform' : 'hertz'
    base = 0.066 + (3 - row) * 0.307
    set lmargin at screen (col == 1 ? 0.092 : 0.552)
    set rmargin at screen (col == 1 ? 0.497 : 0.957)
    set bmargin at screen base
    set tmargin at screen base + 0.292
    set format x (row == 3 ? '10^{%T}' : '')
    set format y (col == 1 ? '10^{%T}' : '')
    set xlabel (row == 3 ? '{/:Italic u} = |{/:Italic v}|/(|{/:Italic ω}|{/:Italic R})' : '') offset 0,0.3
    set ylabel (col == 1 ? 'relative error of ' . symbol[row] : '') offset 2.0,0
    set title (row == 1 ? (col == 1 ? 'Uniform pressure' : 'Hertz pressure') : '') offset 0,-0.6
    unset label
    eval labels[2*row + col - 2]
    set label 'this library' at 1e-4,2e-18 center textcolor rgb blue
    set label '2^{−53}' at graph 1.012, first half_ulp left textcolor rgb ink font ',13'
    plot for [i = 1:|method|] table using 4:(error(pressure, method[i], quantity[row])) \
        with lines linecolor rgb colour[i] linewidth (method[i] eq 'exact' ? 2.6 : 1.5), \
      half_ulp with lines linecolor rgb ink linewidth 0.8
  }
}
unset multiplot
