# What accuracy costs: error against seconds per evaluation, one panel a pressure, the Pareto fronts marked.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_laws.gp
load style
light = '#dedede'
table = data . '/cost_laws.tsv'
fronts = data . '/cost_laws_front.tsv'
eval panel('cost_laws', 940, 1500)

floor = 1e-17   # a double can show no smaller error: zero is drawn here
set logscale xy
set xrange [2.5e-10:2e-2]
set yrange [3e-18:8]
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 10
set ytics 100
unset mxtics
unset mytics
set grid xtics ytics linecolor rgb light linewidth 0.6
set ylabel 'largest error for 10^{−3} ≤ {/:Italic u} ≤ 10^3' offset 0.5,0

# Columns of the table: 1 method, 2 setting, 3 pressure, 4 error, 6 seconds, 10 front.
error(pressure, method) = strcol(3) eq pressure && strcol(1) eq method ? (column(4) > floor ? column(4) : floor) : NaN
labelled(pressure, method, setting) = strcol(2) eq setting ? error(pressure, method) : NaN
# Columns of the fronts: 1 pressure, 2 among, 3 error, 4 seconds; one pressure's front is one stretch of rows.
front(pressure, among) = strcol(1) eq pressure && strcol(2) eq among ? (column(3) > floor ? column(3) : floor) : NaN

# method, colour, point type: circles are exact up to rounding, squares integrate, triangles approximate.
array method = ['quadrature_2d', 'quadrature_1d_qag', 'quadrature_1d_gauss', 'power_quadrature', 'radial_quadrature', \
  'taylor', 'printed_series', 'ellipsoid', 'decoupled', 'pade', 'tanh', \
  'textbook_ke_boost', 'textbook_ke_gsl', 'carlson_boost', 'printed', 'compiled', 'exact']
array colour = [grey, purple, purple, purple, purple, \
  vermilion, vermilion, vermilion, vermilion, vermilion, vermilion, \
  green, green, green, green, blue, blue]
array point = [5, 4, 5, 4, 4, 9, 8, 8, 8, 8, 8, 6, 6, 6, 6, 6, 7]
joined = 'quadrature_2d quadrature_1d_qag quadrature_1d_gauss taylor compiled'

# Labels to the right of a point and to the left of one: method, setting; text; offset.
array right = ['quadrature_1d_qag', 'tolerance 1e-15', 'quadrature_1d_gauss', '4 points', 'power_quadrature', 'library', \
  'taylor', '20 terms', 'ellipsoid', 'same semi-axes', 'tanh', 'epsilon 0.1', 'textbook_ke_boost', 'promotion off', \
  'textbook_ke_boost', 'default', 'textbook_ke_gsl', 'double precision', 'carlson_boost', 'promotion off', \
  'exact', 'one by one']
array right_text = ['1-D form, adaptive', '1-D form, Gauss: 2, 4, 8, … 64 points', 'this library, any {/:Italic σ}(ρ), by quadrature', \
  'Taylor: 2, 3, 4, … 20 terms', 'ellipsoid', 'tanh', 'K, E: Boost', 'promoted', 'K, E: GSL', 'Carlson: Boost', \
  'this library: exact']
array right_y = [0.3, 0.4, 0.8, 0, 0.4, 0, 0.4, 0.4, 0, 0, -0.7]

array left = ['quadrature_2d', 'tolerance 0.01', 'decoupled', 'same semi-axes', 'pade', 'order 2', \
  'printed_series', '(2.8), (2.13), (2.14)', 'printed', '(3.14), (3.17), (3.18)', 'compiled', 'tolerance 0.01', 'exact', 'batch']
array left_text = ['2-D quadrature of (2.1)', 'disk × interval', 'Padé', 'series as printed', 'as printed', 'compiled', \
  'in batches']

set lmargin at screen 0.105
set rmargin at screen 0.975
set multiplot
do for [pressure in 'uniform hertz'] {
  base = pressure eq 'uniform' ? 0.5 : 0
  set bmargin at screen base + 0.045
  set tmargin at screen base + 0.475
  set title (pressure eq 'uniform' ? 'Uniform pressure' : 'Hertz pressure') offset 0,-0.4
  set xlabel 'seconds for Φ, {/:Italic ξ} and {/:Italic η} at one {/:Italic u}'
  set label 1 'zero or below 10^{−17}' at 1.6e-2,floor right offset 0,0.55 textcolor rgb grey
  set label 2 'halo: Pareto front of all methods' at 1.6e-2,1.2 right textcolor rgb '#2f6f9f' font ',13'
  set label 3 'dotted: of those that take one value at a time' at 1.6e-2,0.2 right textcolor rgb ink font ',13'
  plot floor with lines linestyle 8, \
    fronts using 4:(front(pressure, 'all')) with steps linecolor rgb '#c5deee' linewidth 10, \
    fronts using 4:(front(pressure, 'all')) with points linecolor rgb '#c5deee' pointtype 7 pointsize 3, \
    fronts using 4:(front(pressure, 'one')) with steps linecolor rgb ink linewidth 1 dashtype (2,3), \
    for [i = 1:|method|] table using 6:(error(pressure, method[i])) \
      with linespoints linecolor rgb colour[i] linewidth (strstrt(joined, method[i]) ? 1.2 : 0) pointtype point[i] \
      pointsize (method[i] eq 'exact' ? 1.3 : 0.75), \
    for [i = 1:|right_text|] table using 6:(labelled(pressure, right[2*i-1], right[2*i])):(right_text[i]) \
      with labels left offset 1,right_y[i] textcolor rgb ink font ',13', \
    for [i = 1:|left_text|] table using 6:(labelled(pressure, left[2*i-1], left[2*i])):(left_text[i]) \
      with labels right offset -1.3,0 textcolor rgb ink font ',13'
}
unset multiplot
