# What the projection on the friction ball costs: error against seconds per projection, one panel a pressure, the Pareto
# fronts marked.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_projection.gp
load style
light = '#dedede'
table = data . '/cost_projection.tsv'
fronts = data . '/cost_projection_front.tsv'
eval panel('cost_projection', 940, 1300)

set logscale xy
set xrange [3e-9:2e-5]
set yrange [3e-17:30]
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 10
set ytics 100
unset mytics
set mxtics 10
set grid xtics ytics linecolor rgb light linewidth 0.6
set ylabel 'largest error in units of {/:Italic μλ_N}' offset 0.5,0

# Columns of the table: 1 method, 2 setting, 3 pressure, 4 error, 6 seconds.
error(pressure, method) = strcol(3) eq pressure && strcol(1) eq method ? column(4) : NaN
labelled(pressure, method, setting) = strcol(2) eq setting ? error(pressure, method) : NaN
# Columns of the fronts: 1 pressure, 2 error, 3 seconds; one pressure's front is one stretch of rows.
front(pressure) = strcol(1) eq pressure ? column(2) : NaN

# method, colour, point type: circles are exact up to rounding, squares iterate on the law, triangles approximate.
array method = ['coulomb_disk', 'disk', 'decoupled', 'ellipsoid', 'printed', 'series', 'bisection', 'table', 'exact']
array colour = [grey, grey, vermilion, vermilion, vermilion, vermilion, purple, blue, blue]
array point = [8, 8, 8, 8, 10, 9, 5, 6, 7]
joined = 'series bisection table'

array right = ['coulomb_disk', '2 rows', 'printed', '(2.18)', 'printed', '(3.19)', 'series', '40 terms', \
  'bisection', '16 steps', 'table', '32 cells', 'exact', 'this library']
array right_text = ['point contact: disk alone', 'as printed', 'as printed', '(2.18), (3.19) carried on: 3, 5, 10, 20, 40 terms', \
  'bisection with the law: 8, 16, 32, 52 steps', 'table: 4, 8, … 256 cells', 'this library: exact']
array right_y = [0.9, 0.5, 0.5, 0.2, 0.2, 0, 0]
array left = ['decoupled', 'same semi-axes', 'ellipsoid', 'same semi-axes']
array left_text = ['disk × interval', 'ellipsoid']
array left_y = [-0.9, 0.1]

set lmargin at screen 0.105
set rmargin at screen 0.975
set multiplot
do for [pressure in 'uniform hertz'] {
  base = pressure eq 'uniform' ? 0.5 : 0
  set bmargin at screen base + 0.055
  set tmargin at screen base + 0.465
  set title (pressure eq 'uniform' ? 'Uniform pressure' : 'Hertz pressure') offset 0,-0.4
  set xlabel 'seconds per projection'
  set label 1 'halo: Pareto front' at 1.6e-5,4 right textcolor rgb '#2f6f9f' font ',13'
  set label 2 'aim: 300 ns' at 3.2e-7,4 left textcolor rgb ink font ',13'
  set arrow 1 from 3e-7, graph 0 to 3e-7, graph 1 nohead linestyle 8
  plot fronts using 3:(front(pressure)) with steps linecolor rgb '#c5deee' linewidth 10, \
    fronts using 3:(front(pressure)) with points linecolor rgb '#c5deee' pointtype 7 pointsize 3, \
    for [i = 1:|method|] table using 6:(error(pressure, method[i])) \
      with linespoints linecolor rgb colour[i] linewidth (strstrt(joined, method[i]) ? 1.2 : 0) pointtype point[i] \
      pointsize (method[i] eq 'exact' ? 1.3 : 0.75), \
    for [i = 1:|right_text|] table using 6:(labelled(pressure, right[2*i-1], right[2*i])):(right_text[i]) \
      with labels left offset 1,right_y[i] textcolor rgb ink font ',13', \
    for [i = 1:|left_text|] table using 6:(labelled(pressure, left[2*i-1], left[2*i])):(left_text[i]) \
      with labels right offset -1.3,left_y[i] textcolor rgb ink font ',13'
}
unset multiplot
