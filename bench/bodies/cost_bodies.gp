# What many bodies cost: seconds a step over the number of bodies, one and two threads, with a line of slope 1; and, below,
# the sweeps of the solver.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_bodies.gp
load style
light = '#dedede'
table = data . '/cost_bodies.tsv'
eval panel('cost_bodies', 760, 520)
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set grid xtics ytics linecolor rgb light linewidth 0.6
set lmargin at screen 0.13
set rmargin at screen 0.97
set bmargin at screen 0.14
set tmargin at screen 0.965
set xrange [0.8:2e4]
set xlabel 'bodies'
set ylabel 'seconds a step' offset 0.5,0
set key top left reverse Left samplen 2.5 spacing 1.2 font ',14'
# Columns: 1 bodies, 2 threads, 3 seconds.
of(threads) = column(2) == threads ? column(3) : NaN
last = 0
stats table using 1:(column(1) == 2000 && column(2) == 1 ? column(3) : NaN) nooutput
slope(x) = STATS_mean_y/2000*x
plot slope(x) linestyle 8 linewidth 1.4 title 'slope 1', \
  table using 1:(of(1)) with linespoints linecolor rgb blue linewidth 2.2 pointtype 7 pointsize 0.9 title 'one thread', \
  table using 1:(of(2)) with linespoints linecolor rgb vermilion linewidth 1.8 dashtype (8,5) pointtype 5 pointsize 0.9 title 'two threads'
