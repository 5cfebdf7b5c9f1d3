# Share of the random contact problems each solver has solved to 1e-10 within a time per problem.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" robustness.gp
load style
table = data . '/robustness_profile.tsv'
eval panel('robustness', 760, 520)

set logscale x
set xrange [1e-7:1e-1]
set yrange [0:1]
set format x '10^{%T}'
set xlabel 'time per problem [s]'
set ylabel 'share of problems solved to 10^{−10}'
set key bottom right reverse Left
set grid xtics ytics linecolor rgb '#dedede' linewidth 0.6
solved(method) = strcol(1) eq method ? column(3) : NaN

plot table using 2:(solved('automatic')) with lines linecolor rgb blue linewidth 2.6 title 'automatic', \
  '' using 2:(solved('semismooth_newton')) with lines linecolor rgb green linewidth 1.5 title 'semismooth Newton', \
  '' using 2:(solved('gauss_seidel')) with lines linecolor rgb purple linewidth 1.5 title 'Gauss–Seidel', \
  '' using 2:(solved('modified_newton')) with lines linecolor rgb vermilion linewidth 1.5 title 'Modified Newton (4.1)'
