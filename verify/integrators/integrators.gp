# Errors of every scheme over its step in six phases; what becomes of the nutation.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" integrators.gp
load style
light = '#dedede'
errors = data . '/integrator_errors.tsv'
curves = data . '/integrator_nutation.tsv'
sky = '#4aa3d8'
amber = '#c98a00'

array scheme = ['moreau_printed', 'rk4_printed', 'moreau', 'moreau_implicit', 'moreau_adaptive', 'rk4', 'event_driven']
array colour = [vermilion, purple, blue, amber, sky, green, ink]
array mark = [4, 8, 7, 10, 6, 5, 2]
array dash = [2, 2, 1, 2, 1, 1, 1]
array width = [1.5, 1.5, 2.2, 1.5, 2.2, 2.2, 2.2]

# --- errors over the step ---
eval panel('integrator_orders', 940, 860)
array phase = ['flight', 'slip_top', 'roll_top', 'impact_top', 'bounce_top', 'accumulation_top']
array heading = ['free flight', 'slip, Hertz', 'rolling, {/:Italic R} = 0', 'one impact, {/:Italic ε} = 0', 'one impact, {/:Italic ε} = ½', 'accumulation of impacts']
of(p, s) = strcol('phase') eq p && strcol('scheme') eq s && strcol('quantity') eq 'state' ? column('error') : NaN

set logscale xy
set grid xtics ytics linecolor rgb light linewidth 0.6
set xrange [5e-6:3e-2]
set yrange [1e-13:0.3]
set xtics 1e-5,10,1e-2
set multiplot
do for [k = 1:6] {
  col = (k - 1) % 3
  row = (k - 1) / 3
  set lmargin at screen 0.085 + 0.308 * col
  set rmargin at screen 0.367 + 0.308 * col
  set tmargin at screen 0.960 - 0.430 * row
  set bmargin at screen 0.605 - 0.430 * row
  set title heading[k] offset 0,-0.6
  set format y (col == 0 ? '10^{%T}' : '')
  set ytics 1e-12,100,1
  set ylabel (k == 1 || k == 4 ? 'error' : '') offset 1.5,0
  set xlabel (row == 1 ? 'Δ{/:Italic t} [s]' : '') offset 0,0.3
  set format x (row == 1 ? '10^{%T}' : '')
  unset label
  if (k == 1) {
    set label '1' at 1.05e-2,1.1e-2 textcolor rgb grey
    set label '2' at 1.05e-2,4e-5 textcolor rgb grey
    set label '4' at 1.05e-2,2e-7 textcolor rgb grey
  }
  unset key
  plot (k == 1 && x > 1e-5 && x < 1e-2 ? 0.8 * x : NaN) with lines linestyle 8, (k == 1 && x > 1e-5 && x < 1e-2 ? 0.3 * x**2 : NaN) with lines linestyle 8, \
    (k == 1 && x < 1e-2 ? 10 * x**4 : NaN) with lines linestyle 8, \
    for [i = 1:7] errors using 'mean_step':(of(phase[k], scheme[i])) with linespoints linecolor rgb colour[i] \
      linewidth width[i] dashtype dash[i] pointtype mark[i] pointsize 0.75
}
# One key below all.
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.075
set bmargin at screen 0.005
unset title; unset label; unset border; unset tics; unset grid; unset xlabel; unset ylabel; unset logscale
set xrange [0:1]
set yrange [0:1]
set key at screen 0.5,0.045 center center maxrows 2 Left reverse samplen 3 spacing 1.2
plot for [i = 1:7] NaN with linespoints linecolor rgb colour[i] linewidth width[i] \
  dashtype dash[i] pointtype mark[i] pointsize 0.75 title scheme[i] noenhanced
unset multiplot
unset output

# --- nutation ---
reset
load style
eval panel('integrator_nutation', 940, 520)
set logscale y
set grid xtics ytics linecolor rgb light linewidth 0.6
of(w, s, f, h) = strcol('where') eq w && strcol('scheme') eq s && strcol('formulation') eq f && abs(column('setting') / h - 1) < 1e-9 ? column('amplitude') : NaN
exact(w, f) = strcol('where') eq w && strcol('scheme') eq 'event_driven' && strcol('formulation') eq f && column('setting') < 2e-10 ? column('reference') : NaN
array word = ['Table 1', 'Table 2', 'moreau', 'fully implicit', '', 'rk4', '']
array shown = [1, 2, 4, 3, 6]
set yrange [0.4:300]
set format y '%g'
set multiplot
do for [k = 1:2] {
  set lmargin at screen (k == 1 ? 0.085 : 0.560)
  set rmargin at screen (k == 1 ? 0.480 : 0.970)
  set tmargin at screen 0.910
  set bmargin at screen 0.140
  where = k == 1 ? 'flight' : 'floor'
  form = k == 1 ? 'euler' : 'axis'
  set xrange [0:(k == 1 ? 0.4 : 1.2)]
  if (k == 1) { set xtics 0,0.1 } else { set xtics 0,0.3 }
  set title (k == 1 ? 'free flight, in Euler’s angles, Δ{/:Italic t} = 5·10^{−4} s' : 'from the start of 5.4, without Euler’s angles, Δ{/:Italic t} = 5·10^{−4} s') offset 0,-0.5
  set xlabel '{/:Italic t} [s]' offset 0,0.3
  set ylabel (k == 1 ? 'amplitude of the nutation [rad/s]' : '') offset 1.5,0
  if (k == 1) { set key at graph 0.03,0.03 left bottom Left reverse samplen 3 spacing 1.15 } else { unset key }
  plot curves using 't':(exact(where, form)) with lines linecolor rgb '#b8b8b8' linewidth 7 title 'exact', \
    for [j = 1:5] curves using 't':(of(where, scheme[shown[j]], form, 5e-4)) with linespoints linecolor rgb colour[shown[j]] \
      linewidth 2 dashtype dash[shown[j]] pointtype mark[shown[j]] pointsize 0.7 title word[shown[j]]
}
unset multiplot
