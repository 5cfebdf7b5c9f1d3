# What the contact problem costs: residual reached against seconds per problem, one panel a family, cold start; ours in
# blue, Siconos in vermilion, hollow where a solver leaves problems unsolved; the Pareto front marked.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" cost_solvers.gp
load style
light = '#dedede'
table = data . '/cost_solvers.tsv'
fronts = data . '/cost_solvers_front.tsv'
eval panel('cost_solvers', 940, 1300)

floor = 1e-17   # smaller residuals are drawn here
set logscale xy
set yrange [4e-18:1]
set format x '10^{%T}'
set xtics 10
set ytics 1e-16,1e4,1
unset mytics
set mxtics 10
set grid xtics ytics linecolor rgb light linewidth 0.6

# Columns of the table: 1 method, 2 setting, 3 error, 4 seconds, 5 family, 6 start, 7 origin, 8 failures.
shown(family, origin) = strcol(5) eq family && strcol(6) eq 'cold' && strcol(7) eq origin
low(x) = x > floor ? x : floor
all_solved(family, origin) = shown(family, origin) && column(8) == 0 ? low(column(3)) : NaN
some_solved(family, origin) = shown(family, origin) && column(8) > 0 ? low(column(3)) : NaN
method(family, name) = shown(family, 'contensou') && strcol(1) eq name && column(8) == 0 ? low(column(3)) : NaN
# Columns of the fronts: 1 family, 2 start, 3 error, 4 seconds.
front(family) = strcol(1) eq family && strcol(2) eq 'cold' ? low(column(3)) : NaN

array family = ['coulomb_1', 'coulomb_1_free', 'uniform_1', 'hertz_1', 'coulomb_n', 'contensou_n']
array panel_text = ['one Coulomb contact', 'one Coulomb contact, {/:Italic W} positive definite', 'one contact, uniform pressure', 'one contact, Hertz pressure', \
  '2 to 8 Coulomb contacts', '2 to 8 contacts, Coulomb–Contensou']
array mine = ['modified_newton', 'gauss_seidel', 'semismooth_newton', 'one_contact', 'automatic']
array colour = [grey, purple, green, ink, blue]
array symbol = [11, 13, 9, 5, 7]
array mine_text = ['modified Newton (4.17)', 'Gauss–Seidel', 'semismooth Newton', 'one contact, called directly', 'automatic']

set multiplot
do for [i = 1:|family|] {
  col = (i - 1) % 2
  row = (i - 1) / 2
  set lmargin at screen (col == 0 ? 0.092 : 0.552)
  set rmargin at screen (col == 0 ? 0.505 : 0.965)
  set bmargin at screen 0.725 - row * 0.330
  set tmargin at screen 0.970 - row * 0.330
  set title panel_text[i] offset 0,-0.6
  set xlabel 'seconds per problem' offset 0,0.3
  set ylabel (col == 0 ? 'largest residual' : '') offset 2.0,0
  set format y (col == 0 ? '10^{%T}' : '')
  if (row < 2) { set xrange [5e-8:1e-3] } else { set xrange [2e-6:1e-1] }
  set key at graph 0.97,0.03 right bottom samplen 1 spacing 1.05 font ',13'
  plot fronts using 4:(front(family[i])) with steps linecolor rgb '#c5deee' linewidth 9, \
    fronts using 4:(front(family[i])) with points linecolor rgb '#c5deee' pointtype 7 pointsize 2.4, \
    table using 4:(some_solved(family[i], 'siconos')) with points linecolor rgb vermilion pointtype 6 pointsize 0.7, \
    table using 4:(all_solved(family[i], 'siconos')) with points linecolor rgb vermilion pointtype 7 pointsize 0.8, \
    table using 4:(some_solved(family[i], 'contensou')) with points linecolor rgb blue pointtype 6 pointsize 0.8, \
    for [k = 1:|mine|] table using 4:(method(family[i], mine[k])) with points linecolor rgb (colour[k]) \
      pointtype symbol[k] pointsize 1.1 title (i == 3 ? mine_text[k] : ''), \
    keyentry with points linecolor rgb blue pointtype 6 pointsize 0.8 title (i == 4 ? 'ours, some unsolved' : ''), \
    keyentry with points linecolor rgb vermilion pointtype 6 pointsize 0.7 title (i == 4 ? 'Siconos, some unsolved' : ''), \
    keyentry with points linecolor rgb vermilion pointtype 7 pointsize 0.8 title (i == 4 ? 'Siconos, all solved' : '')
}
unset multiplot
