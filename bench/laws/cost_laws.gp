# What accuracy costs: error against seconds per evaluation, one panel a pressure, the Pareto fronts marked.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_laws.gp
load style
table = data . '/cost_laws.tsv'
eval panel('cost_laws', 940, 1500)

floor = 1e-17   # a double can show no smaller error: zero is drawn here
set logscale xy
set xrange [4e-9:2e-2]
set yrange [3e-18:8]
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 10
set ytics 100
set grid xtics ytics linecolor rgb light linewidth 0.6
set lmargin 10
set rmargin 3
set ylabel 'largest error for 10^{−3} ≤ {/:Italic u} ≤ 10^3' offset 0.5,0

# Columns of the table: 1 method, 2 setting, 3 pressure, 4 error, 6 seconds, 10 front.
error(pressure, method) = strcol(3) eq pressure && strcol(1) eq method ? (column(4) > floor ? column(4) : floor) : NaN
labelled(pressure, method, setting) = strcol(2) eq setting ? error(pressure, method) : NaN
one_front(pressure) = strcol(3) eq pressure && strcol(10) ne '-' && strcol(2) ne 'batch' ? 1 : 0

# method, colour, point type: circles are exact up to rounding, squares integrate, triangles approximate.
array method = ['quadrature_2d', 'quadrature_1d_qag', 'quadrature_1d_gauss', 'power_quadrature', 'radial_quadrature', \
  'taylor', 'printed_series', 'ellipsoid', 'decoupled', 'pade', 'tanh', \
  'textbook_ke_boost', 'textbook_ke_gsl', 'carlson_boost', 'printed', 'compiled', 'exact']
array colour = [grey, purple, purple, purple, purple, \
  vermilion, vermilion, vermilion, vermilion, vermilion, vermilion, \
  green, green, green, green, blue, blue]
array point = [5, 4, 5, 4, 4, 9, 8, 8, 8, 8, 8, 6, 6, 6, 6, 6, 7]
joined = 'quadrature_2d quadrature_1d_qag quadrature_1d_gauss taylor compiled'

# method, setting, text, offset: labels to the right of a point, and to the left of one.
array right_method = ['quadrature_2d', 'quadrature_1d_qag', 'quadrature_1d_gauss', 'power_quadrature', 'taylor', \
  'ellipsoid', 'tanh', 'textbook_ke_boost', 'textbook_ke_boost', 'textbook_ke_gsl', 'carlson_boost', 'exact']
array right_setting = ['tolerance 1e-06', 'tolerance 1e-15', '4 points', 'library', '20 terms', \
  'same semi-axes', 'epsilon 0.1', 'promotion off', 'default', 'double precision', 'promotion off', 'one by one']
array right_text = ['2-D quadrature of (2.1)', '1-D form, adaptive', '1-D form, Gauss: 4, 8, … 64 points', \
  'this library: any n, any σ(ρ), by quadrature', 'Taylor: 2, 3, 4, … 20 terms', 'ellipsoid', 'tanh', \
  'K, E: Boost', 'promoted', 'K, E: GSL', 'Carlson: Boost', 'this library: exact']
array right_x = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1.2]
array right_y = [0.5, 0.3, 0.4, 0, 0, 0.4, 0, 0.4, 0, 0, 0, -0.4]

array left_method = ['decoupled', 'pade', 'printed_series', 'printed', 'compiled', 'exact']
array left_setting = ['same semi-axes', 'order 2', '(2.8), (2.13), (2.14)', '(3.14), (3.17), (3.18)', 'tolerance 1e-10', 'batch']
array left_text = ['disk × interval', 'Padé', 'series as printed', 'as printed', 'compiled', 'in batches']
array left_x = [-1, -1, -1, -1, -1, -1.2]
array left_y = [0.5, 0, -0.4, 0, 0, 0]

set multiplot layout 2,1
do for [pressure in 'uniform hertz'] {
  set title (pressure eq 'uniform' ? 'Uniform pressure' : 'Hertz pressure') offset 0,-0.4
  set xlabel 'seconds for Φ, {/:Italic ξ} and {/:Italic η} at one {/:Italic u}'
  set label 1 'zero or below 10^{−17}' at 1.7e-2,floor right offset 0,0.55 textcolor rgb grey
  plot floor with lines linestyle 8, \
    table using 6:(strcol(3) eq pressure && strcol(10) eq 'all' ? (column(4) > floor ? column(4) : floor) : NaN) \
      smooth unique with fsteps linecolor rgb '#bfd9ea' linewidth 9, \
    table using 6:(one_front(pressure) ? (column(4) > floor ? column(4) : floor) : NaN) \
      smooth unique with fsteps linecolor rgb ink linewidth 1 dashtype (3,3), \
    for [i = 1:|method|] table using 6:(error(pressure, method[i])) \
      with linespoints linecolor rgb colour[i] linewidth (strstrt(joined, method[i]) ? 1.2 : 0) pointtype point[i] \
      pointsize (method[i] eq 'exact' ? 1.3 : 0.75), \
    for [i = 1:|right_method|] table using 6:(labelled(pressure, right_method[i], right_setting[i])):(right_text[i]) \
      with labels left offset right_x[i],right_y[i] textcolor rgb ink font ',13', \
    for [i = 1:|left_method|] table using 6:(labelled(pressure, left_method[i], left_setting[i])):(left_text[i]) \
      with labels right offset left_x[i],left_y[i] textcolor rgb ink font ',13'
}
unset multiplot
