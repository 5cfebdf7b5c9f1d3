# Rates of growth of the inclination of the tippe-top spinning upright at 180 rad/s over the contact radius.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" stability_growth.gp
load style
light = '#dedede'
table = data . '/stability_growth.tsv'
eval panel('stability_growth', 860, 560)

set lmargin at screen 0.105
set rmargin at screen 0.80
set bmargin at screen 0.13
set tmargin at screen 0.93
set logscale xy
set xrange [8e-6:2.5e-3]
set yrange [3e-6:100]
set format y '10^{%T}'
set xtics ('10^{−5}' 1e-5, '10^{−4}' 1e-4, '10^{−3}' 1e-3)
unset mxtics
unset mytics
set grid xtics ytics linecolor rgb light linewidth 0.6
set xlabel '{/:Italic R} [m]'
set ylabel 'rate of growth or decay of {/:Italic θ} [1/s]' offset 1.4,0
set key bottom right Left reverse samplen 3 spacing 1.25 width -4

array place = ['trivial', 'trivial', 'inverted', 'inverted']
array mode = ['nutation', 'precession', 'nutation', 'precession']
array colour = [vermilion, purple, blue, green]
of(k, value) = strcol('position') eq place[k] && strcol('mode') eq mode[k] ? abs(value) : NaN
set label 1 "on the body:\nnutation grows" at 2.7e-3, 4.6 left textcolor rgb vermilion font ',13'
set label 2 "on the tip:\nnutation decays" at 2.7e-3, 30 left textcolor rgb blue font ',13'
set label 3 "precession decays" at 2.7e-3, 0.70 left textcolor rgb green font ',13'
set label 4 "on the body:\nprecession grows" at 2.7e-3, 0.19 left textcolor rgb purple font ',13'
set label 5 "by (5.31) decays" at 2.7e-3, 0.018 left textcolor rgb purple font ',13'

plot for [k = 1:4] table using 'radius':(of(k, column('rate_531'))) with lines linecolor rgb colour[k] linewidth 1.8 dashtype (8,5), \
     for [k = 1:4] table using 'radius':(of(k, column('simulated_531'))) with points pointtype 6 pointsize 0.9 linewidth 1.4 linecolor rgb colour[k], \
     for [k = 1:4] table using 'radius':(of(k, column('rate_slow'))) with lines linecolor rgb colour[k] linewidth 1.8, \
     for [k = 1:4] table using 'radius':(of(k, column('simulated'))) with points pointtype 7 pointsize 0.7 linecolor rgb colour[k], \
     NaN with lines linecolor rgb ink linewidth 1.8 dashtype (8,5) title 'roots of (5.31)', \
     NaN with points pointtype 6 pointsize 0.9 linewidth 1.4 linecolor rgb ink title 'simulated without drilling torque', \
     NaN with lines linecolor rgb ink linewidth 1.8 title 'linear, with drilling torque', \
     NaN with points pointtype 7 pointsize 0.7 linecolor rgb ink title 'simulated'
