# The inclination of the tippe-top of LG03 5.4 under some hypotheses, and how long inversion takes over the contact radius.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" story.gp
load style
light = '#dedede'

table = data . '/story_theta.tsv'
eval panel('story', 860, 520)
set lmargin at screen 0.085
set rmargin at screen 0.84
set bmargin at screen 0.13
set tmargin at screen 0.86
set xrange [0:6.5]
set yrange [0:pi]
set xtics 1
set ytics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)
set xlabel '{/:Italic t} [s]'
set ylabel '{/:Italic θ} [rad]' offset 1,0
unset key
# The paper's times.
array time = [1.5, 1.6, 4, 4.55, 4.65, 5.4]
do for [k = 1:6] {
  set arrow k from time[k], 0 to time[k], pi nohead linewidth 1 dashtype (3,4) linecolor rgb '#888888'
}
set label 11 'LG03: stick 1.5' at 1.5, pi * 1.035 right textcolor rgb '#666666' font ',12'
set label 12 '1.6   upright   4' at 2.8, pi * 1.035 center textcolor rgb '#666666' font ',12'
set label 13 'body 4.55' at 4.55, pi * 1.085 right textcolor rgb '#666666' font ',12'
set label 14 '4.65   both   5.4' at 5.025, pi * 1.035 center textcolor rgb '#666666' font ',12'
array column_name = ['hertz', 'uniform', 'ellipsoid', 'fitted', 'radial']
array colour = [ink, blue, green, vermilion, purple]
array title = ['Hertz, exact', 'uniform, exact', 'ellipsoid', "R, μ fitted", "projection\nalong rays"]
do for [k = 1:5] {
  set label 20 + k title[k] at 6.58, pi * (0.97 - 0.10 * k) left textcolor rgb colour[k] font ',13'
}
plot for [k = 1:5] table using 't':column_name[k] with lines linewidth (k == 1 ? 2.2 : 1.3) linecolor rgb colour[k]

reset
load style
table = data . '/inversion_over_radius.tsv'
eval panel('inversion_over_radius', 860, 520)
set lmargin at screen 0.085
set rmargin at screen 0.80
set bmargin at screen 0.13
set tmargin at screen 0.95
set logscale x
set xrange [8e-6:2.5e-3]
set yrange [0:4.2]
set xtics ('10^{−5}' 1e-5, '10^{−4}' 1e-4, '10^{−3}' 1e-3)
set ytics 1
unset mxtics
set grid xtics ytics linecolor rgb light linewidth 0.6
set xlabel '{/:Italic R} [m]'
set ylabel '{/:Italic t} [s]' offset 1,0
unset key
set arrow 1 from 5e-4, 0 to 5e-4, 4.2 nohead linewidth 1 dashtype (3,4) linecolor rgb '#888888'
set label 1 "LG03 5.4" at 5.3e-4, 4.0 left textcolor rgb '#666666' font ',12'
array pressure = ['hertz', 'uniform', 'no_drilling']
array tint = [vermilion, blue, green]
set label 2 "uniform" at 2.7e-3, 2.08 left textcolor rgb blue font ',13'
set label 3 "Hertz" at 2.7e-3, 1.88 left textcolor rgb vermilion font ',13'
set label 4 "Hertz without\ndrilling torque" at 2.7e-3, 1.62 left textcolor rgb green font ',13'
set label 6 "the stick touches" at 1.7e-5, 3.1 left textcolor rgb ink font ',13'
set label 7 "θ = π/2" at 1.2e-5, 1.05 left textcolor rgb ink font ',13'
of(k, value) = strcol('pressure') eq pressure[k] && column('theta_0') == 0.1 ? value : NaN
set datafile missing NaN
plot for [k = 1:2] table using 'radius':(of(k, column('tip'))) with linespoints pointtype 7 pointsize 0.5 dashtype (8,5) linewidth 1.6 linecolor rgb tint[k], \
     for [k = 1:3] table using 'radius':(of(k, column('half'))) with linespoints pointtype 7 pointsize 0.5 linewidth 1.6 linecolor rgb tint[k]
