# What the motion of the tippe-top costs: error of the event times (above) and of the inclination at 1 s (below) against
# wall time, one curve a method and formulation: full and solid in coordinates without singularity, hollow and dashed in
# Euler angles; the Pareto front marked.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_integrators.gp
load style
light = '#dedede'
table = data . '/cost_integrators.tsv'
fronts = data . '/cost_integrators_front.tsv'
eval panel('cost_integrators', 940, 1300)

set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 10
set ytics 100
unset mytics
set mxtics 10
set grid xtics ytics linecolor rgb light linewidth 0.6

# Columns of the table: 1 method, 3 error, 4 seconds, 5 formulation, 10 error_theta_1s, 11 seconds_1s.
shown(name, formulation, y) = strcol(1) eq name && strcol(5) eq formulation ? column(y) : NaN
# Columns of the fronts: 1 measure, 2 error, 3 seconds, 6 error_bar.
front(measure, y) = strcol(1) eq measure ? column(y) : NaN

array method = ['moreau_printed', 'rk4_printed', 'moreau_implicit', 'moreau', 'moreau_adaptive', 'rk4', 'event_driven']
array text = ['Moreau as printed (Table 1)', 'Runge–Kutta as printed (Table 2)', 'Moreau, fully implicit', 'Moreau', \
  'Moreau, automatic steps', 'Runge–Kutta 4', 'event-driven']
array colour = [grey, vermilion, '#b8860b', purple, green, blue, ink]
array full = [9, 5, 15, 11, 13, 7, 7]
array hollow = [8, 4, 14, 10, 12, 6, 6]

set lmargin at screen 0.105
set rmargin at screen 0.975
set multiplot
do for [k = 1:2] {
  y = k == 1 ? 3 : 10
  x = k == 1 ? 4 : 11
  measure = k == 1 ? 'events' : 'theta_1s'
  set bmargin at screen (k == 1 ? 0.555 : 0.055)
  set tmargin at screen (k == 1 ? 0.965 : 0.465)
  set title (k == 1 ? 'Times of the impacts before they accumulate' : 'Inclination after the first second, which is smooth') offset 0,-0.4
  set xlabel (k == 1 ? 'seconds for the 8 s of Section 5.4' : 'seconds for the first second')
  set ylabel (k == 1 ? 'largest error in s' : 'error of {/:Italic θ}(1 s) in rad') offset 0.5,0
  if (k == 1) { set xrange [4e-3:2e1]; set yrange [1e-11:20] } else { set xrange [1e-4:4]; set yrange [3e-13:20] }
  unset arrow
  unset label
  unset key
  if (k == 1) {
    set arrow 1 from 0.05, graph 0 to 0.05, 1e-6 nohead linestyle 8
    set arrow 2 from graph 0, first 1e-6 to 0.05, 1e-6 nohead linestyle 8
    set label 1 'aim' at 0.047,3.5e-7 right textcolor rgb ink font ',13'
    set key at graph 0.985,0.27 right center samplen 2 spacing 1.1 font ',13'
  }
  set label 2 'halo: Pareto front' at graph 0.02,0.05 left textcolor rgb '#2f6f9f' font ',13'
  stats fronts using (front(measure, 6)) nooutput
  set arrow 3 from graph 0, first STATS_max to graph 1, first STATS_max nohead linecolor rgb grey linewidth 1
  set label 3 'error bar of the reference' at graph 0.985, first STATS_max*0.45 right textcolor rgb grey font ',13'
  plot fronts using 3:(front(measure, 2)) with steps linecolor rgb '#c5deee' linewidth 8, \
    fronts using 3:(front(measure, 2)) with points linecolor rgb '#c5deee' pointtype 7 pointsize 2.5, \
    for [i = 1:|method|] table using x:(shown(method[i], 'euler', y)) with linespoints linecolor rgb (colour[i]) \
      linewidth 1.0 dashtype (4,4) pointtype hollow[i] pointsize 0.9, \
    for [i = 1:|method|] table using x:(shown(method[i], 'axis', y)) with linespoints linecolor rgb (colour[i]) \
      linewidth (i > 5 ? 2.2 : 1.5) pointtype full[i] pointsize (i == 7 ? 1.1 : 0.9) title (k == 1 ? text[i] : ''), \
    keyentry with linespoints linecolor rgb grey linewidth 1.0 dashtype (4,4) pointtype 6 pointsize 0.9 \
      title (k == 1 ? 'hollow: in Euler angles' : '')
}
unset multiplot
