# The sliding, spinning disc: u = v/(ωR) over time for a cone, and where it ends over the inertia.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" scenes.gp
load style
light = '#dedede'
array name = ['uniform', 'hertz', 'paraboloid']
array title_of = ['uniform', 'Hertz', 'paraboloid']
array colour = [blue, vermilion, green]
set style line 31 linecolor rgb blue linewidth 2
set style line 32 linecolor rgb vermilion linewidth 2 dashtype (8,5)
set style line 33 linecolor rgb green linewidth 2 dashtype (2,3)

ends = data . '/scenes_disc_ends.tsv'
over_time = data . '/scenes_disc.tsv'
limits = data . '/scenes_limits.tsv'

eval panel('scenes_disc', 860, 760)
set multiplot
set logscale y
set format y '%g'

# Above: over time.
set lmargin at screen 0.10
set rmargin at screen 0.80
set tmargin at screen 0.96
set bmargin at screen 0.58
set logscale x
set xrange [1:1e-3] reverse
set xtics ('1' 1, '0.1' 0.1, '0.01' 0.01, '0.001' 1e-3)
set yrange [0.08:4]
set ytics (0.1, 0.2, 0.5, 1, 2, 3)
set grid ytics linecolor rgb light linewidth 0.6
set xlabel 'part of the time that is left'
set ylabel '{/:Italic u} = {/:Italic v}/({/:Italic ωR})' offset 1.2,0
of(k, value) = strcol('pressure') eq name[k] ? value : NaN
stats over_time using (of(1, column('limit'))) nooutput; u1 = STATS_max
stats over_time using (of(2, column('limit'))) nooutput; u2 = STATS_max
stats over_time using (of(3, column('limit'))) nooutput; u3 = STATS_max
array limit = [u1, u2, u3]
do for [k = 1:3] {
  set arrow 10 + k from 1, limit[k] to 1e-3, limit[k] nohead linecolor rgb colour[k] linewidth 1 dashtype (2,3)
  set label 10 + k sprintf('%s: {/:Italic u}* = %.3f', title_of[k], limit[k]) at 0.93e-3, limit[k] left textcolor rgb colour[k] font ',13'
}
set label 1 'a cone, {/:Italic κ} = 0.3' at graph 0.98, 0.07 right font ',13'
array start = [0.1, 0.4, 1, 2, 3]
part(k, j) = (strcol('pressure') eq name[k] && column('start') == start[j]) ? column('u') : NaN
plot for [k = 1:3] for [j = 1:5] over_time using 'left':(part(k, j)) with lines linecolor rgb colour[k] linewidth 1.6
do for [k = 1:3] { unset arrow 10 + k; unset label 10 + k }
unset label 1
unset logscale x

# Below: the limits over κ.
set tmargin at screen 0.47
set bmargin at screen 0.09
set xrange [0.14:0.76]
set yrange [0.02:50]
set ytics (0.02, 0.1, 0.5, 1, 2, 10, 50)
set xtics 0.1
set xlabel '{/:Italic κ} = {/:Italic I}/({/:Italic mR}^2)'
set ylabel 'last {/:Italic u}' offset 1.2,0
set label 2 'cone' at 0.3, 0.027 center font ',13'
set label 3 'disc' at 0.5, 0.027 center font ',13'
set label 4 "{/:Italic u} → ∞\nbelow 1/(4 + 2{/:Italic n})" at 0.155, 25 left font ',13'
set label 5 "{/:Italic u} → 0\nfrom 2/(3 + 2{/:Italic n}) on" at 0.70, 0.06 center font ',13'
set arrow 20 from 0.3, 0.036 to 0.3, 50 nohead linestyle 8
set arrow 21 from 0.5, 0.036 to 0.5, 50 nohead linestyle 8
set arrow 22 from graph 0, first 1 to graph 1, first 1 nohead linestyle 8
do for [k = 1:3] {
  n = (k - 1)/2.0
  set arrow 22 + k from 1/(4 + 2*n), 20 to 1/(4 + 2*n), 50 nohead linecolor rgb colour[k] linewidth 1 dashtype (2,3)
  set arrow 25 + k from 2/(3 + 2*n), 0.02 to 2/(3 + 2*n), 0.05 nohead linecolor rgb colour[k] linewidth 1 dashtype (2,3)
}
set key at screen 0.82, screen 0.45 left top Left reverse samplen 3 spacing 1.25
positive(x) = x > 0 && x < 1e3 ? x : NaN
near(k) = positive(column('limit')) == positive(column('limit')) ? of(k, column('u')) : NaN
plot for [k = 1:3] limits using 'kappa':(positive(column(name[k]))) with lines linestyle 30 + k title title_of[k], \
     for [k = 1:3] ends using 'kappa':(near(k)) with points pointtype 6 pointsize 0.9 linewidth 1.4 linecolor rgb colour[k], \
     NaN with points pointtype 6 pointsize 0.9 linewidth 1.4 linecolor rgb ink title 'runs'
unset multiplot
