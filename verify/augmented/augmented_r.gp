# Iterations of the Modified Newton method of LG03 4.1 over its parameter r, on the tippe-top's contact matrices.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" augmented_r.gp
load style
light = '#dedede'
table = data . '/augmented_r.tsv'
eval panel('augmented_r', 940, 620)

set lmargin at screen 0.09
set rmargin at screen 0.965
set bmargin at screen 0.13
set tmargin at screen 0.93
set logscale xy
set xrange [7e-5:700]
set yrange [4:150000]
set format y '10^{%T}'
set xtics ('10^{−4}' 1e-4, '10^{−3}' 1e-3, '10^{−2}' 1e-2, '10^{−1}' 1e-1, '1' 1, '10' 10)
unset mxtics
unset mytics
set grid xtics ytics linecolor rgb light linewidth 0.6
set xlabel '{/:Italic r} λ_{max}({/:Bold W})/2' offset -13,0.3
set ylabel 'iterations to a residual of 10^{−10}' offset 1.2,0
set clip one

# Above r = 2/λ_max there is no convergence where contacts stick.
set object 1 rectangle from 1,4 to 20,150000 fillcolor rgb '#f6e3d9' fillstyle solid noborder behind
set arrow 1 from 1,4 to 1,150000 nohead linecolor rgb vermilion linewidth 1.2 dashtype (6,4)
set label 1 '{/:Italic r} > 2/λ_{max}: cycles in stick' at 1.15,90000 left textcolor rgb vermilion font ',13'
set label 2 'automatic {/:Italic r}' at 30,90000 left textcolor rgb ink font ',13'

array case = ['body_stick', 'both_let_go', 'both_impact', 'tip_impact_stick', 'both_slip', 'body_slip', 'body_impact']
array words = ['body sticks', 'body sticks, tip lifts', 'both strike and stick', 'tip strikes and sticks', 'both slide', 'body slides and spins', 'body strikes, sliding']
array colour = [vermilion, purple, green, grey, blue, ink, '#c49a00']
array dash = ['1', '(10,4)', '(6,3)', '1', '1', '1', '(2,3)']

# Columns: 1 case, 3 method, 5 r_over_limit, 8 iterations_1e10.
given(i) = strcol(1) eq case[i] && strcol(3) eq 'given' ? column(8) : NaN
automatic(i) = strcol(1) eq case[i] && strcol(3) eq 'automatic' ? column(8) : NaN
do for [i = 1:|case|] {
  eval sprintf("set linetype %d linecolor rgb '%s' linewidth 2.2 dashtype %s", 20 + i, colour[i], dash[i])
}
# Names stand beside the markers, moved apart where markers crowd.
array shift = [0.86, 1, 1, 1.13, 1, 0.92, 0.98]
plot for [i = 1:|case|] table using 5:(given(i)) with lines linetype 20 + i, \
  for [i = 1:|case|] table using (30):(automatic(i)) with points pointtype 7 pointsize 0.8 linecolor rgb colour[i], \
  for [i = 1:|case|] table using (42):(automatic(i)*shift[i]):(words[i]) with labels left textcolor rgb colour[i] font ',12'
